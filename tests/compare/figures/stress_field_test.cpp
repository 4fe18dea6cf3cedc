// Stresses of triangles under homogeneous deformations, whose values are known.
#include "compare/figures/stress_field.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace validate;

namespace {

const membrane::StVenantKirchhoff law{8, 0.25};
constexpr double thickness_A = 2;

membrane::Problem disc() {
  membrane::Problem problem;
  problem.sheet = membrane::paper_disc(100);
  problem.law = law;
  problem.load = membrane::PointLoad{};
  return problem;
}

/// u = G X on every node.
Eigen::VectorXd displaced(const membrane::Mesh& mesh, const Eigen::Matrix<double, 3, 2>& G) {
  Eigen::VectorXd u(3 * mesh.node_count());
  for (int n = 0; n < mesh.node_count(); ++n) u.segment<3>(3 * n) = G * mesh.nodes[static_cast<std::size_t>(n)];
  return u;
}

std::vector<TriangleStress> field(const Eigen::Matrix<double, 3, 2>& G) {
  const membrane::Problem problem = disc();
  const membrane::Mesh mesh = membrane::mesh_of(problem);
  return stress_field(problem, mesh, thickness_A, displaced(mesh, G));
}

TEST(StressField, EqualBiaxialStretch) {
  const double stretch = 1.1;
  Eigen::Matrix<double, 3, 2> G = Eigen::Matrix<double, 3, 2>::Zero();
  G(0, 0) = G(1, 1) = stretch - 1;
  // S = E·h/(1 − ν) E, Cauchy force = λ² S/(λ² λ3) = S/λ3, λ3² = 1 − 2ν/(1 − ν)(λ² − 1).
  const double S = 8 / 0.75 * (stretch * stretch - 1) / 2;
  const double lambda3 = std::sqrt(1 - 2 * 0.25 / 0.75 * (stretch * stretch - 1));
  const auto all = field(G);
  ASSERT_EQ(all.size(), 1936u);
  for (const TriangleStress& t : all) {
    EXPECT_EQ(t.state, membrane::SheetState::taut);
    EXPECT_NEAR(t.larger_eV_per_A3 * thickness_A * lambda3 / S, 1, 1e-9);
    EXPECT_NEAR(t.smaller_eV_per_A3 * thickness_A * lambda3 / S, 1, 1e-9);
  }
}

TEST(StressField, AWrinkledStripPullsAlongItsAxisOnly) {
  // Stretched along a direction of 30°, pressed together across it: S1 = E·h E1, nothing across.
  const double stretch = 1.05, squeeze = 0.8, angle = std::acos(-1.0) / 6;
  const Eigen::Vector2d m(std::cos(angle), std::sin(angle)), across(-m[1], m[0]);
  Eigen::Matrix<double, 3, 2> G = Eigen::Matrix<double, 3, 2>::Zero();
  G.topRows<2>() = stretch * m * m.transpose() + squeeze * across * across.transpose() - Eigen::Matrix2d::Identity();
  const double S = 8 * (stretch * stretch - 1) / 2;
  const double width2 = 1 - 0.25 * (stretch * stretch - 1);  // λ2² = λ3² = 1 − ν(λ1² − 1)
  for (const TriangleStress& t : field(G)) {
    EXPECT_EQ(t.state, membrane::SheetState::wrinkled);
    EXPECT_NEAR(t.larger_eV_per_A3 * thickness_A / (stretch * S / width2), 1, 1e-9);
    EXPECT_NEAR(t.smaller_eV_per_A3, 0, 1e-9);
    EXPECT_NEAR(std::abs(t.direction.dot(m)), 1, 1e-9);
  }
}

TEST(StressField, ASlackSheetBearsNothing) {
  Eigen::Matrix<double, 3, 2> G = Eigen::Matrix<double, 3, 2>::Zero();
  G(0, 0) = G(1, 1) = -0.1;
  for (const TriangleStress& t : field(G)) {
    EXPECT_EQ(t.state, membrane::SheetState::slack);
    EXPECT_EQ(t.larger_eV_per_A3, 0);
  }
}

}  // namespace
