// Newton on one sheet: balance of forces, equal answers of both controls, quadratic end.
#include "membrane/triangles/newton.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "membrane/triangles/model.hpp"
#include "membrane/triangles/start.hpp"

namespace membrane {
namespace {

Problem problem() {
  Problem p;
  p.sheet = DiscSheet{.radius_A = 110, .rings = 24};
  p.law = StVenantKirchhoff{8.03368, 0.19};
  p.load = DiscLoad{10};
  return p;
}

class Sheet : public ::testing::Test {
 protected:
  const Problem problem_ = problem();
  Model model_{problem_};
  const Eigen::VectorXd direction_ = model_.pattern().direction();
  Newton newton_{model_.energy(), direction_, std::get<Triangles>(problem_.discretisation)};

  Eigen::VectorXd start(double depth) {
    const Eigen::VectorXd shape = StiffenedSheet(model_, newton_).under_forces(direction_);
    return shape * (depth / direction_.dot(shape));
  }
};

TEST_F(Sheet, StiffenedStartIsThatOfALinearMembrane) {
  // Uniform load over a disc of c/a, tension N: w(0) = (F / 2πN) (ln(a/c) + ½).
  Eigen::VectorXd forces = direction_ / model_.mesh().copies;
  const Eigen::VectorXd shape = StiffenedSheet(model_, newton_).under_forces(forces);
  const double tension = 0.01 * 8.03368;
  // 24 rings: the mesh's error is (44/24)² of the 0.12 % that 44 rings have.
  EXPECT_NEAR(-shape[2] * 2 * std::numbers::pi * tension / (std::log(11.0) + 0.5), 1, 4e-3);
  EXPECT_TRUE(model_.stretching().material().relaxed);  // left as it was
}

TEST_F(Sheet, AmplitudeBalancesTheLoad) {
  const Eigen::VectorXd shape = start(1);
  const Eigen::VectorXd forces = 0.5 * direction_;
  const double amplitude = balanced_amplitude(model_, shape, forces);
  const auto potential = [&](double a) {
    Eigen::VectorXd unused;
    return model_.energy().energy(a * shape, unused) - a * forces.dot(shape);
  };
  EXPECT_LT(potential(amplitude), potential(1.02 * amplitude));
  EXPECT_LT(potential(amplitude), potential(0.98 * amplitude));
}

TEST_F(Sheet, EndsQuadratically) {
  Problem p = problem_;
  Newton newton(model_.energy(), direction_, {.relative_residual = 1e-12, .keep_factor = false});
  Eigen::VectorXd u = start(20);
  const Equilibrium at = newton.solve({Control::conjugate_depth, 20}, u);
  ASSERT_TRUE(at.converged) << at.reason;
  const auto& r = at.residual_history;
  ASSERT_GE(r.size(), 4u);
  // r_{k+1} ~ r_k²: the order from the last three residuals above rounding
  std::size_t last = r.size() - 1;
  while (r[last] < 1e-11) --last;
  const double order = std::log(r[last] / r[last - 1]) / std::log(r[last - 1] / r[last - 2]);
  EXPECT_GT(order, 1.7) << r[last - 2] << " " << r[last - 1] << " " << r[last];
}

TEST_F(Sheet, RimCarriesTheLoad) {
  Eigen::VectorXd u = start(20);
  const Equilibrium at = newton_.solve({Control::conjugate_depth, 20}, u);
  ASSERT_TRUE(at.converged) << at.reason;
  EXPECT_LE(at.relative_residual, 1e-8);
  EXPECT_NEAR(direction_.dot(u), 20, 1e-12);
  Eigen::VectorXd gradient;
  model_.energy().energy(u, gradient);
  double reaction = 0;
  for (int n = 0; n < model_.mesh().node_count(); ++n)
    if (model_.mesh().held[n][2]) reaction += gradient[3 * n + 2];
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
  Eigen::VectorXd u = Eigen::VectorXd::Constant(3 * model_.mesh().node_count(), std::nan(""));
  const Equilibrium at = newton_.solve({Control::conjugate_depth, 20}, u);
  EXPECT_FALSE(at.converged);
  EXPECT_FALSE(at.reason.empty());
}

}  // namespace
}  // namespace membrane
