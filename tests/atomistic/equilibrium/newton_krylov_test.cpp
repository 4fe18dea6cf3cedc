#include "atomistic/equilibrium/newton_krylov.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

namespace {

using namespace atomistic;
using Eigen::VectorXd;

/// A chain of Rosenbrock's curved valleys, steep across and flat along; its lowest point is (1, …, 1), energy 0.
Evaluation valleys(const VectorXd& x) {
  Evaluation e{0, VectorXd::Zero(x.size())};
  for (Eigen::Index i = 0; i + 1 < x.size(); ++i) {
    const double off = x[i + 1] - x[i] * x[i], along = 1 - x[i];
    e.energy += 100 * off * off + along * along;
    e.gradient[i] += -400 * off * x[i] - 2 * along;
    e.gradient[i + 1] += 200 * off;
  }
  return e;
}

Minimisation unconditioned(Evaluation (*energy)(const VectorXd&)) {
  return {.evaluate = energy,
          .precondition = [](const VectorXd& r) { return r; },
          .constraint = {},
          .constraint_response = {}};
}

TEST(NewtonKrylov, FollowsACurvedValleyToItsEnd) {
  VectorXd x = VectorXd::Constant(12, -0.9);
  const MinimiserReport report =
      minimise_by_newton(unconditioned(valleys), {.force_tolerance = 1e-8, .max_evaluations = 20000}, x);
  ASSERT_TRUE(report.converged) << report.reason;
  EXPECT_LT(valleys(x).gradient.norm(), 1e-7);
  EXPECT_LT((x - VectorXd::Ones(12)).norm(), 1e-6);
  EXPECT_GT(report.trust_radius, 0);
}

/// Two wells at x = ±1 and a saddle between, where the curvature along x is negative.
Evaluation two_wells(const VectorXd& x) {
  VectorXd g = 3 * x;
  g[0] = 4 * x[0] * (x[0] * x[0] - 1);
  return {std::pow(x[0] * x[0] - 1, 2) + 1.5 * x.tail(x.size() - 1).squaredNorm(), g};
}

TEST(NewtonKrylov, LeavesASaddleWhereTheCurvatureIsNegative) {
  VectorXd x = VectorXd::Constant(6, 0.4);
  x[0] = 1e-3;
  const MinimiserReport report = minimise_by_newton(unconditioned(two_wells), {.force_tolerance = 1e-9}, x);
  ASSERT_TRUE(report.converged) << report.reason;
  EXPECT_NEAR(x[0], 1, 1e-9);
  EXPECT_LT(x.tail(5).norm(), 1e-9);
}

TEST(NewtonKrylov, KeepsTheConstraintAndFindsItsMultiplier) {
  Minimisation problem = unconditioned(valleys);
  problem.precondition = [](const VectorXd& r) {  // some metric
    return VectorXd(r.cwiseQuotient(VectorXd::LinSpaced(r.size(), 10, 400)));
  };
  problem.constraint = VectorXd::Unit(9, 4) + VectorXd::Unit(9, 7);
  VectorXd x = VectorXd::Constant(9, 0.3);
  const MinimiserReport report = minimise_by_newton(problem, {.force_tolerance = 1e-8, .max_evaluations = 20000}, x);
  ASSERT_TRUE(report.converged) << report.reason;
  EXPECT_NEAR(problem.constraint.dot(x), 0.6, 1e-12);
  EXPECT_LT((valleys(x).gradient - report.multiplier * problem.constraint).norm(), 1e-7);
  EXPECT_GT(std::abs(report.multiplier), 0.01);
}

TEST(NewtonKrylov, SaysWhyItStopped) {
  VectorXd x = VectorXd::Constant(12, -0.9), y = x;
  const MinimiserReport few =
      minimise_by_newton(unconditioned(valleys), {.force_tolerance = 1e-9, .max_evaluations = 30}, x);
  EXPECT_FALSE(few.converged);
  EXPECT_EQ(few.reason, "too many force evaluations");
  EXPECT_LT(few.last.energy, valleys(y).energy);
  const MinimiserReport stopped =
      minimise_by_newton(unconditioned(valleys), {.force_tolerance = 1e-9}, y, [](int, double) { return false; });
  EXPECT_EQ(stopped.reason, "given up by the caller");
}

}  // namespace
