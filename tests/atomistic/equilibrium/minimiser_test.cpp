#include "atomistic/equilibrium/minimiser.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

namespace {

using namespace atomistic;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// ½ xᵀHx − bᵀx + ¼ w Σ x⁴, stiffnesses from 0.01 to 100; the quartic part changes them by up to a half.
struct QuarticWell {
  MatrixXd h;
  VectorXd b;
  double w = 2e-6;

  explicit QuarticWell(int n) : h(MatrixXd::Random(n, n)), b(VectorXd::Random(n)) {
    const MatrixXd q = h.householderQr().householderQ();
    h = q * VectorXd::LinSpaced(n, -2, 2).unaryExpr([](double e) { return std::pow(10, e); }).asDiagonal() *
        q.transpose();
  }
  Evaluation operator()(const VectorXd& x) const {
    return {0.5 * x.dot(h * x) - b.dot(x) + 0.25 * w * x.array().pow(4).sum(),
            h * x - b + VectorXd(w * x.array().pow(3))};
  }
};

Minimisation preconditioned(const QuarticWell& well) {
  return {.evaluate = well,
          .precondition = [&well](const VectorXd& r) { return VectorXd(well.h.llt().solve(r)); },
          .constraint = {}};
}

TEST(Minimiser, FindsTheMinimumOfAnIllConditionedWell) {
  std::srand(1);
  const QuarticWell well(30);
  VectorXd x = VectorXd::Zero(30);
  const MinimiserReport report = minimise(preconditioned(well), {.force_tolerance = 1e-10, .longest_step = 1e9}, x);
  EXPECT_TRUE(report.converged) << report.reason;
  EXPECT_LT(well(x).gradient.norm(), 1e-9);
}

TEST(Minimiser, ThePreconditionerSavesEvaluations) {
  std::srand(1);
  const QuarticWell well(30);
  Minimisation plain = preconditioned(well);
  plain.precondition = [](const VectorXd& r) { return r; };
  VectorXd x = VectorXd::Zero(30), y = x;
  const MinimiserOptions options{.force_tolerance = 1e-8, .longest_step = 1e9, .max_evaluations = 5000};
  EXPECT_LT(4 * minimise(preconditioned(well), options, x).evaluations, minimise(plain, options, y).evaluations);
}

TEST(Minimiser, KeepsTheConstraintAndFindsItsMultiplier) {
  std::srand(2);
  QuarticWell well(12);
  well.w = 1;  // far from the preconditioner: a long history
  Minimisation problem = preconditioned(well);
  problem.constraint = VectorXd::Zero(12);
  problem.constraint.tail(3).setConstant(1.0 / 3);
  VectorXd x = VectorXd::Zero(12);
  x[11] = 0.9;
  const double held = problem.constraint.dot(x);
  const MinimiserReport report = minimise(problem, {.force_tolerance = 1e-10, .longest_step = 1e9}, x);
  ASSERT_TRUE(report.converged) << report.reason;
  EXPECT_GT(report.evaluations, 20);
  EXPECT_NEAR(problem.constraint.dot(x), held, 1e-12);
  EXPECT_LT((well(x).gradient - report.multiplier * problem.constraint).norm(), 1e-9);
}

TEST(Minimiser, TakesAKnownResponseOfTheConstraint) {
  std::srand(2);
  const QuarticWell well(12);
  Minimisation solved = preconditioned(well);
  solved.constraint = VectorXd::Unit(12, 3);
  Minimisation known = solved;
  known.constraint_response = well.h.llt().solve(solved.constraint);
  VectorXd x = VectorXd::Zero(12), y = x;
  const MinimiserReport a = minimise(solved, {.force_tolerance = 1e-10}, x),
                        b = minimise(known, {.force_tolerance = 1e-10}, y);
  EXPECT_EQ(a.evaluations, b.evaluations);
  EXPECT_TRUE(x.isApprox(y, 1e-12));
}

TEST(Minimiser, IgnoresRoundingInTheEnergy) {
  std::srand(3);
  const QuarticWell well(30);
  int call = 0;
  Minimisation noisy = preconditioned(well);
  noisy.evaluate = [&](const VectorXd& x) {
    Evaluation e = well(x);
    e.energy += 1e5 + 1e-7 * std::sin(1e3 * ++call);  // as a sum over 10⁵ eV leaves it
    return e;
  };
  VectorXd x = VectorXd::Zero(30), exact = x;
  const MinimiserOptions options{.force_tolerance = 1e-6, .longest_step = 1e9};
  const int without_noise = minimise(preconditioned(well), options, exact).evaluations;
  const MinimiserReport report = minimise(noisy, options, x);
  EXPECT_TRUE(report.converged) << report.reason;
  EXPECT_LE(report.evaluations, 2 * without_noise);
}

TEST(Minimiser, LimitsTheStepOfEveryAtom) {
  const QuarticWell well(6);
  VectorXd previous = VectorXd::Zero(6);
  double longest = 0;
  Minimisation problem = preconditioned(well);
  problem.evaluate = [&](const VectorXd& x) {
    for (int atom : {0, 1}) longest = std::max(longest, (x - previous).segment<3>(3 * atom).norm());
    previous = x;
    return well(x);
  };
  VectorXd x = VectorXd::Zero(6);
  minimise(problem, {.force_tolerance = 1e-8, .longest_step = 0.05}, x);
  EXPECT_LE(longest, 0.05 + 1e-12);
}

TEST(Minimiser, GivesUpWhenTheCallerSaysSo) {
  const QuarticWell well(30);
  VectorXd x = VectorXd::Zero(30);
  const auto before_the_fourth = [](int evaluations, double) { return evaluations < 4; };
  const MinimiserReport report = minimise(preconditioned(well), {.force_tolerance = 1e-12}, x, before_the_fourth);
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.evaluations, 4);
  EXPECT_FALSE(report.reason.empty());
}

TEST(Minimiser, ReportsThatItStoppedForWantOfEvaluations) {
  const QuarticWell well(30);
  VectorXd x = VectorXd::Zero(30);
  const MinimiserReport report = minimise(preconditioned(well), {.force_tolerance = 1e-12, .max_evaluations = 3}, x);
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.evaluations, 3);
  EXPECT_FALSE(report.reason.empty());
}

}  // namespace
