#include "atomistic/equilibrium/guide.hpp"

#include <gtest/gtest.h>

namespace atomistic {
namespace {

/// Outward 0.01 r, depth 3 − 0.001 r², which cubics through four points give exactly.
Problem guided(double radius_A) {
  Problem problem;
  problem.radius_A = radius_A;
  Guide guide{.level = 2, .spacing_A = 0.5, .outward_A = {}, .depth_A = {}};
  for (double r = 0; r <= radius_A + 5; r += guide.spacing_A) {
    guide.outward_A.push_back(0.01 * r);
    guide.depth_A.push_back(3 - 0.001 * r * r);
  }
  problem.guides = {guide};
  return problem;
}

TEST(Guide, MovesAtomsAlongTheirRadiusAndDown) {
  const Sheet sheet = make_sheet(20, 2.46, 0, 3);
  const auto u = guided_displacement(guided(20), sheet, 2);
  ASSERT_TRUE(u);
  ASSERT_EQ(u->size(), 3 * sheet.free_atoms);
  for (int i = 0; i < sheet.free_atoms; ++i) {
    const Eigen::Vector2d place = sheet.position(i).head<2>();
    EXPECT_LT((u->segment<2>(3 * i) - 0.01 * place).norm(), 1e-13);
    EXPECT_NEAR((*u)[3 * i + 2], -(3 - 0.001 * place.squaredNorm()), 1e-12);
  }
}

TEST(Guide, HoldsForItsLevelAloneAndNothingBeyondItsRim) {
  const Sheet sheet = make_sheet(20, 2.46, 0, 3);
  EXPECT_FALSE(guided_displacement(guided(20), sheet, 2.1));
  EXPECT_FALSE(guided_displacement(Problem{}, sheet, 2));
  const auto small = guided_displacement(guided(5), sheet, 2);  // known up to 10 Å
  ASSERT_TRUE(small);
  for (int i = 0; i < sheet.free_atoms; ++i) {
    if (sheet.position(i).head<2>().norm() <= 10) continue;
    EXPECT_EQ(small->segment<3>(3 * i), Eigen::Vector3d::Zero());
  }
}

}  // namespace
}  // namespace atomistic
