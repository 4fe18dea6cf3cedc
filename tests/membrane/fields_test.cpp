// Stresses of triangles under homogeneous deformations, whose values are known.
#include "membrane/triangles/fields.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace membrane {
namespace {

const StVenantKirchhoff law{8, 0.25};
Problem disc() {
  Problem problem;
  problem.sheet = paper_disc(100);
  problem.law = law;
  problem.load = PointLoad{};
  return problem;
}

/// u = G X on every node.
Eigen::VectorXd displaced(const Mesh& mesh, const Eigen::Matrix<double, 3, 2>& G) {
  Eigen::VectorXd u(3 * mesh.node_count());
  for (int n = 0; n < mesh.node_count(); ++n) u.segment<3>(3 * n) = G * mesh.nodes[static_cast<std::size_t>(n)];
  return u;
}

SheetFields field(const Eigen::Matrix<double, 3, 2>& G) {
  const Problem problem = disc();
  const Mesh mesh = mesh_of(problem);
  return fields_of(problem, mesh, displaced(mesh, G));
}

TEST(SheetFields, EqualBiaxialStretch) {
  const double stretch = 1.1;
  Eigen::Matrix<double, 3, 2> G = Eigen::Matrix<double, 3, 2>::Zero();
  G(0, 0) = G(1, 1) = stretch - 1;
  // S = E·h/(1 − ν) E, Cauchy force = λ² S/(λ² λ3) = S/λ3, λ3² = 1 − 2ν/(1 − ν)(λ² − 1).
  const double S = 8 / 0.75 * (stretch * stretch - 1) / 2;
  const double lambda3 = std::sqrt(1 - 2 * 0.25 / 0.75 * (stretch * stretch - 1));
  const SheetFields all = field(G);
  ASSERT_EQ(all.state.size(), 1936u);
  for (std::size_t t = 0; t < all.state.size(); ++t) {
    EXPECT_EQ(all.state[t], SheetState::taut);
    EXPECT_NEAR(all.cauchy_1_eV_per_A2[t] * lambda3 / S, 1, 1e-9);
    EXPECT_NEAR(all.cauchy_2_eV_per_A2[t] * lambda3 / S, 1, 1e-9);
  }
}

TEST(SheetFields, AWrinkledStripPullsAlongItsAxisOnly) {
  // Stretched along a direction of 30°, pressed together across it: S1 = E·h E1, nothing across.
  const double stretch = 1.05, squeeze = 0.8, angle = std::acos(-1.0) / 6;
  const Eigen::Vector2d m(std::cos(angle), std::sin(angle)), across(-m[1], m[0]);
  Eigen::Matrix<double, 3, 2> G = Eigen::Matrix<double, 3, 2>::Zero();
  G.topRows<2>() = stretch * m * m.transpose() + squeeze * across * across.transpose() - Eigen::Matrix2d::Identity();
  const double S = 8 * (stretch * stretch - 1) / 2;
  const double width2 = 1 - 0.25 * (stretch * stretch - 1);  // λ2² = λ3² = 1 − ν(λ1² − 1)
  const SheetFields all = field(G);
  for (std::size_t t = 0; t < all.state.size(); ++t) {
    EXPECT_EQ(all.state[t], SheetState::wrinkled);
    EXPECT_NEAR(all.cauchy_1_eV_per_A2[t] / (stretch * S / width2), 1, 1e-9);
    EXPECT_NEAR(all.cauchy_2_eV_per_A2[t], 0, 1e-9);
    EXPECT_NEAR(all.direction_rad[t], angle, 1e-9);
  }
}

TEST(SheetFields, ASlackSheetBearsNothing) {
  Eigen::Matrix<double, 3, 2> G = Eigen::Matrix<double, 3, 2>::Zero();
  G(0, 0) = G(1, 1) = -0.1;
  const SheetFields all = field(G);
  for (std::size_t t = 0; t < all.state.size(); ++t) {
    EXPECT_EQ(all.state[t], SheetState::slack);
    EXPECT_EQ(all.cauchy_1_eV_per_A2[t], 0);
  }
}

}  // namespace
}  // namespace membrane
