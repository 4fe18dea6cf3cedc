// Dead forces on the rim of a sheet that slides.
#include "atomistic/loads/rim_pull.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <stdexcept>

namespace atomistic {
namespace {

Sheet sliding(double radius_A) { return make_sheet(radius_A, 2.42, 0, 10, {.edge = Edge::sliding}); }

TEST(RimPull, IsOutwardsAndInBalance) {
  const Sheet sheet = sliding(40);
  const Eigen::VectorXd forces = rim_pull(sheet, 0.02);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double outwards = 0;
  for (int i = 0; i < sheet.free_atoms; ++i) {
    const Eigen::Vector3d f = forces.segment<3>(3 * i);
    sum += f;
    outwards += f.head<2>().dot(sheet.position(i).head<2>().normalized());
    EXPECT_EQ(f.norm() > 0, sheet.slides[static_cast<std::size_t>(i)]);
  }
  EXPECT_LT(sum.norm(), 1e-12);
  EXPECT_NEAR(outwards, 2 * std::numbers::pi * rim_radius_A(sheet) * 0.02, 1e-12);
  EXPECT_EQ(rim_pull(sheet, 0).norm(), 0);
}

TEST(RimPull, NeedsARimThatSlides) { EXPECT_THROW(rim_pull(make_sheet(40, 2.42, 0, 10), 0.02), std::invalid_argument); }

TEST(RimPull, DisplacementIsOutwards) {
  const Sheet sheet = sliding(40);
  EXPECT_NEAR(rim_displacement_A(sheet, 1.01 * sheet.positions), 0.01 * rim_radius_A(sheet), 1e-12);
}

}  // namespace
}  // namespace atomistic
