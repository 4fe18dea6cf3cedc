// Newton on one sheet: balance of forces, equal answers of both controls, quadratic end.
#include "membrane/newton.hpp"

#include <gtest/gtest.h>

#include "membrane/grading.hpp"
#include "membrane/loads/pattern.hpp"
#include "membrane/quarter_disc.hpp"
#include "membrane/start.hpp"

namespace membrane {
namespace {

class Sheet : public ::testing::Test {
 protected:
  const QuarterDisc disc_ = quarter_disc(graded_radii({110, 10, 0, 24}));
  const Pattern pattern_ = disc_pattern(disc_.mesh, 10);
  Assembly assembly_{disc_.mesh, {StVenantKirchhoff{8.03368, 0.19}, Voigt::Zero(), true}};
  Newton newton_{disc_.mesh, assembly_, pattern_.direction()};

  Eigen::VectorXd start(double depth) const {
    return start_shape(disc_.mesh, pattern_.weights, 110, 10, depth);
  }
};

TEST_F(Sheet, StartHasTheDepthAskedFor) { EXPECT_NEAR(pattern_.direction().dot(start(20)), 20, 1e-12); }

TEST_F(Sheet, RimCarriesTheLoad) {
  Eigen::VectorXd u = start(20);
  const Equilibrium at = newton_.solve({Control::conjugate_depth, 20}, u);
  ASSERT_TRUE(at.converged) << at.reason;
  EXPECT_LE(at.relative_residual, 1e-8);
  EXPECT_NEAR(pattern_.direction().dot(u), 20, 1e-12);
  Eigen::VectorXd gradient;
  assembly_.energy(u, gradient);
  double reaction = 0;
  for (int n = 0; n < disc_.mesh.node_count(); ++n)
    if (disc_.mesh.held[n][2]) reaction += gradient[3 * n + 2];
  EXPECT_NEAR(reaction / at.force_eV_per_A, 1, 1e-7);
}

TEST_F(Sheet, BothControlsFindTheSameState) {
  Eigen::VectorXd by_depth = start(20);
  const Equilibrium at = newton_.solve({Control::conjugate_depth, 20}, by_depth);
  ASSERT_TRUE(at.converged) << at.reason;
  Eigen::VectorXd by_force = start(17);
  const Equilibrium same = newton_.solve({Control::force, at.force_eV_per_A}, by_force);
  ASSERT_TRUE(same.converged) << same.reason;
  EXPECT_LE((by_depth - by_force).lpNorm<Eigen::Infinity>(), 1e-6);
  EXPECT_NEAR(same.energy_eV / at.energy_eV, 1, 1e-8);
}

TEST_F(Sheet, ForceIsTheDerivativeOfTheEnergyAlongThePath) {
  const auto energy = [&](double depth) {
    Eigen::VectorXd u = start(depth);
    const Equilibrium at = newton_.solve({Control::conjugate_depth, depth}, u);
    EXPECT_TRUE(at.converged) << at.reason;
    return at.energy_eV;
  };
  Eigen::VectorXd u = start(20);
  const double force = newton_.solve({Control::conjugate_depth, 20}, u).force_eV_per_A;
  EXPECT_NEAR((energy(20.01) - energy(19.99)) / 0.02 / force, 1, 1e-6);
}

TEST_F(Sheet, NonsenseIsReportedNotThrown) {
  Eigen::VectorXd u = Eigen::VectorXd::Constant(disc_.mesh.dof_count(), std::nan(""));
  const Equilibrium at = newton_.solve({Control::conjugate_depth, 20}, u);
  EXPECT_FALSE(at.converged);
  EXPECT_FALSE(at.reason.empty());
}

}  // namespace
}  // namespace membrane
