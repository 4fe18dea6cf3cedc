#include "compare/fitting/fit.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <random>

#include "compare/base/units.hpp"
#include "compare/fitting/models/eq16.hpp"
#include "compare/fitting/run_fit.hpp"
#include "tests/compare/results/sample_result.hpp"

using namespace validate;

namespace {

const Eq16 model{110, 0.165};
const double start[] = {1, 0};
constexpr double true_Eh = 20, true_pretension = 0.02;

std::vector<double> depths() {
  std::vector<double> d;
  for (int i = 1; i <= 12; ++i) d.push_back(2 * i);
  return d;
}

std::vector<double> noisy_forces(const std::vector<double>& d, double sd, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, sd);
  std::vector<double> f;
  for (const double depth : d) f.push_back(model.force(depth, true_Eh, true_pretension) + noise(random));
  return f;
}

struct NormalEquations {
  Eigen::Vector2d solution;
  Eigen::Matrix2d inverse;  // (JᵀWJ)⁻¹
};

NormalEquations solve_normal_equations(const std::vector<double>& d, const std::vector<double>& f,
                                       const std::vector<double>& w) {
  Eigen::Matrix2d A = Eigen::Matrix2d::Zero();
  Eigen::Vector2d b = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < d.size(); ++i) {
    Eigen::Vector2d g;
    model.gradient(d[i], {}, {g.data(), 2});
    A += w[i] * g * g.transpose();
    b += w[i] * g * f[i];
  }
  return {A.ldlt().solve(b), A.inverse()};
}

class LeastSquares : public testing::TestWithParam<bool> {};

TEST_P(LeastSquares, AgreesWithTheNormalEquations) {
  const bool weighted = GetParam();
  const auto d = depths(), f = noisy_forces(d, 0.05, 7);
  std::vector<double> w(d.size(), 1.0);
  if (weighted) {
    for (std::size_t i = 0; i < w.size(); ++i) w[i] = 1 / (f[i] * f[i]);
  }
  const auto report = least_squares(model, d, f, start, {.weights = weighted ? w : std::vector<double>{}});
  ASSERT_TRUE(report.converged) << report.reason;

  const auto [solution, inverse] = solve_normal_equations(d, f, w);
  double chi2 = 0;
  for (std::size_t i = 0; i < d.size(); ++i) {
    chi2 += w[i] * std::pow(f[i] - model.force(d[i], solution[0], solution[1]), 2);
  }
  const Eigen::Matrix2d covariance = inverse * chi2 / static_cast<double>(d.size() - 2);
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(report.parameters[i] / solution[i], 1, 1e-9);
    EXPECT_NEAR(report.standard_errors[i] / std::sqrt(covariance(i, i)), 1, 1e-9);
  }
  EXPECT_NEAR(report.correlation(0, 1), covariance(0, 1) / std::sqrt(covariance(0, 0) * covariance(1, 1)), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Weights, LeastSquares, testing::Bool());

TEST(LeastSquares, StandardErrorsAreTheScatterOverManyNoisyCurves) {
  const int curves = 2000;
  const double sd = 0.05;
  const auto d = depths();
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  Eigen::Vector2d mean_variance = Eigen::Vector2d::Zero();
  const Eigen::Vector2d truth(true_Eh, true_pretension);
  for (int i = 0; i < curves; ++i) {
    const auto report = least_squares(model, d, noisy_forces(d, sd, 1000u + static_cast<unsigned>(i)), start);
    ASSERT_TRUE(report.converged) << report.reason;
    const Eigen::Vector2d error = Eigen::Vector2d(report.parameters.data()) - truth;
    scatter += error * error.transpose() / curves;
    mean_variance += report.covariance.diagonal() / curves;
  }
  const std::vector<double> equal(d.size(), 1.0);
  const Eigen::Matrix2d known = sd * sd * solve_normal_equations(d, d, equal).inverse;
  // Relative standard error of a variance from n samples is √(2/n) = 3.2 %; four of them.
  const double tolerance = 4 * std::sqrt(2.0 / curves);
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(scatter(i, i) / known(i, i), 1, tolerance);
    EXPECT_NEAR(mean_variance[i] / known(i, i), 1, tolerance);
  }
  EXPECT_NEAR(scatter(0, 1) / known(0, 1), 1, tolerance);
}

TEST(LeastSquares, ConvergesOnExactDataWithAParameterThatIsZero) {
  const auto d = depths();
  std::vector<double> f;
  for (const double depth : d) f.push_back(model.force(depth, true_Eh, 0));
  const auto report = least_squares(model, d, f, start);
  ASSERT_TRUE(report.converged) << report.reason;
  EXPECT_NEAR(report.parameters[0] / true_Eh, 1, 1e-12);
  EXPECT_NEAR(report.parameters[1], 0, 1e-12);
}

TEST(LeastSquares, KnowsNoUnits) {
  const auto d = depths(), f = noisy_forces(d, 0.05, 3);
  const double factor = 1e-9;
  std::vector<double> small;
  for (const double force : f) small.push_back(factor * force);
  const auto report = least_squares(model, d, f, start), scaled = least_squares(model, d, small, start);
  ASSERT_TRUE(scaled.converged) << scaled.reason;
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(scaled.parameters[i] / (factor * report.parameters[i]), 1, 1e-9);
    EXPECT_NEAR(scaled.standard_errors[i] / (factor * report.standard_errors[i]), 1, 1e-9);
  }
}

TEST(LeastSquares, SaysWhyThereIsNoSolution) {
  const std::vector<double> two = {1, 2}, same(6, 3.0), force = {1, 2, 3, 4, 5, 6};
  EXPECT_EQ(least_squares(model, two, two, start).reason, "2 points for 2 parameters");
  EXPECT_EQ(least_squares(model, same, force, start).reason, "the points do not determine the parameters");
  const double not_finite[] = {std::numeric_limits<double>::quiet_NaN(), 0};
  const auto report = least_squares(model, force, force, not_finite);
  EXPECT_FALSE(report.converged);
  EXPECT_FALSE(report.reason.empty());
}

Run exact_run() {
  validate::Run run;
  run.a_A = 110;
  run.nu = 0.165;
  run.Eh_eV_per_A2 = true_Eh;
  run.pretension_eV_per_A2 = true_pretension;
  run.depth_A = depths();
  for (const double depth : run.depth_A) {
    run.force_eV_per_A.push_back(model.force(depth, true_Eh, true_pretension));
    run.converged.push_back(true);
  }
  return run;
}

TEST(FitRun, RecoversTheConstantsOfAnExactCurve) {
  validate::Run run = exact_run();
  fit_run(run);
  ASSERT_FALSE(run.fits.empty()) << run.fit_skipped;
  EXPECT_NEAR(run.fits[0].Eh_eV_per_A2, true_Eh, 1e-9);
  EXPECT_NEAR(run.fits[0].pretension_eV_per_A2, true_pretension, 1e-9);
  EXPECT_NEAR(run.fits[0].rms_relative, 0, 1e-12);
  EXPECT_EQ(run.fits[0].points, 12);
  EXPECT_EQ(run.fits[0].window_A, (std::array{2.0, 24.0}));
  EXPECT_LT(run.fits[0].correlation, -0.8);
}

TEST(FitRun, LeavesOutArtefactsAndWhatDidNotConverge) {
  validate::Run run = exact_run();
  run.model = Model::atomistic;
  settle_part(run);
  run.atoms().artefact.assign(12, false);
  run.atoms().artefact[11] = true;
  run.force_eV_per_A[11] *= 2;
  run.converged[0] = false;
  run.force_eV_per_A[0] *= 5;
  run.force_eV_per_A[5] = std::numeric_limits<double>::quiet_NaN();
  fit_run(run);
  ASSERT_FALSE(run.fits.empty()) << run.fit_skipped;
  EXPECT_NEAR(run.fits[0].Eh_eV_per_A2, true_Eh, 1e-9);
  EXPECT_EQ(run.fits[0].points, 9);
  EXPECT_EQ(run.fits[0].window_A, (std::array{4.0, 22.0}));
}

TEST(FitRun, RmsIsOverTheLargestForce) {
  validate::Run run = exact_run();
  for (std::size_t i = 0; i < 12; ++i) run.force_eV_per_A[i] += i % 2 ? 0.01 : -0.01;
  fit_run(run);
  ASSERT_FALSE(run.fits.empty()) << run.fit_skipped;
  EXPECT_NEAR(run.fits[0].rms_relative * run.force_eV_per_A[11], 0.01, 5e-4);  // the fit takes up a little of it
}

TEST(FitRun, UnderFourPointsThereIsAReasonInstead) {
  validate::Run run = exact_run();
  run.model = Model::atomistic;
  settle_part(run);
  run.atoms().artefact.assign(12, true);
  for (const int i : {0, 1, 2}) run.atoms().artefact[i] = false;
  fit_run(run);
  EXPECT_TRUE(run.fits.empty());
  EXPECT_EQ(run.fit_skipped, "3 usable points of 12 (9 in the artefact zone, 0 not converged); a fit needs 4");
  run.atoms().artefact[3] = false;
  fit_run(run);
  EXPECT_FALSE(run.fits.empty());
  EXPECT_EQ(run.fit_skipped, "");
}

TEST(FitRun, WithoutKnownConstantsThereIsAReasonInstead) {
  validate::Run run = exact_run();
  run.nu = not_known;  // the card failed
  fit_run(run);
  EXPECT_TRUE(run.fits.empty());
  EXPECT_NE(run.fit_skipped.find("Poisson"), std::string::npos);
}

}  // namespace
