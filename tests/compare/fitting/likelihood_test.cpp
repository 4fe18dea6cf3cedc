// The likelihood of a curve with noise in force and depth: its gradient, its maximum, its intervals.
#include "compare/fitting/likelihood.hpp"

#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>

#include <cmath>

#include "compare/base/units.hpp"
#include "compare/fitting/fit.hpp"
#include "compare/fitting/models/eq16.hpp"
#include "compare/fitting/normal.hpp"
#include "compare/fitting/sheet_table.hpp"

using namespace validate;
using Eigen::VectorXd;

namespace {

constexpr double Eh = 342 / N_per_m_per_eV_per_A2, pretension = 0.34 / N_per_m_per_eV_per_A2;
constexpr double sigma_force = 5 / nN_per_eV_per_A, sigma_depth = 10;

const ForceModel& disc() {
  static const ForceModel table = sheet_table({5000, 0.165, 165}, {1200, Eh, 0.0045});
  return table;
}

double force_at(double depth, double N0 = pretension) { return depth > 0 ? disc().at(depth, Eh, N0).force : 0; }

/// 230 points of a drum from −20 to 98 nm, its contact at 3 nm and its force zero at 5 nN.
CurvePoints drum(std::uint32_t seed, double N0 = pretension, double noise = 1) {
  Normal normal(seed);
  CurvePoints p;
  for (int i = 0; i < 230; ++i) {
    const double depth = std::lerp(-200.0, 980.0, i / 229.0);
    p.depth_A.push_back(depth + noise * sigma_depth * normal());
    p.force_eV_per_A.push_back(force_at(depth - 30, N0) + sigma_force + noise * sigma_force * normal());
  }
  p.noise.force_eV_per_A = sigma_force;
  p.noise.depth_A = sigma_depth;
  return p;
}

// ---- gradient

struct Asked {
  const char* name;
  FreeZeros free;
  bool force_noise_known, depth_noise_known;
  double compliance;
  int inputs;
};

class Gradient : public testing::TestWithParam<Asked> {
 protected:
  static Likelihood likelihood() {
    const Asked& asked = GetParam();
    CurvePoints points = drum(3);
    if (!asked.force_noise_known) points.noise.force_eV_per_A.reset();
    if (!asked.depth_noise_known) points.noise.depth_A.reset();
    points.compliance_A2_per_eV = asked.compliance;
    std::vector<UncertainInput> inputs;
    for (int k = 0; k < asked.inputs; ++k) inputs.push_back({"force", scaled(disc(), 1.02 + 0.01 * k)});
    return {points, disc(), asked.free, inputs};
  }

  static VectorXd somewhere(const Likelihood& l) {
    VectorXd theta = VectorXd::Zero(l.parameter_count());
    theta[0] = 1.02 * Eh;
    theta[1] = 0.9 * pretension;
    if (const int i = l.contact_index(); i >= 0) theta[i] = 35;
    if (const int i = l.force_zero_index(); i >= 0) theta[i] = 1.2 * sigma_force;
    if (const int i = l.slope_index(); i >= 0) theta[i] = 0.01;
    for (int k = 0; k < GetParam().inputs; ++k) theta[l.first_input() + k] = 0.4 - 0.7 * k;
    if (const int i = l.force_noise_index(); i >= 0) theta[i] = 1.2 * sigma_force * sigma_force;
    if (const int i = l.depth_noise_index(); i >= 0) theta[i] = 0.8 * sigma_depth * sigma_depth;
    return theta;
  }
};

// With the slopes held, as every fit holds them, it is exact: what is left falls with the square of the step.
TEST_P(Gradient, IsTheDerivative) {
  Likelihood l = likelihood();
  const VectorXd theta = somewhere(l);
  l.take_slopes(theta);
  const Likelihood::At at = l.at(theta);
  for (int i = 0; i < theta.size(); ++i) {
    const double natural = 1 / std::sqrt(at.information(i, i));
    const auto error = [&](double step) {
      VectorXd up = theta, down = theta;
      up[i] += step * natural;
      down[i] -= step * natural;
      return std::abs((l.at(up).minus_two_log - l.at(down).minus_two_log) / (2 * step) - at.gradient[i] * natural);
    };
    EXPECT_LT(error(1e-2), 2e-4) << i;
    EXPECT_LT(error(1e-3), std::max(error(1e-2) / 30, 1e-6)) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(All, Gradient,
                         testing::Values(Asked{"plain", {}, true, true, 0, 0},
                                         Asked{"contact", {true}, true, true, 0, 0},
                                         Asked{"zeros", {true, true, true}, true, true, 0, 0},
                                         Asked{"inputs", {true, true}, true, true, 0, 2},
                                         Asked{"noise", {true, true, true}, false, false, 0, 0},
                                         Asked{"force_noise", {true, true}, false, true, 0, 1},
                                         Asked{"heights", {true, true}, true, true, 0.8, 0},
                                         Asked{"heights_noise", {true, true, true}, false, false, 0.8, 1}),
                         [](const auto& test) { return test.param.name; });

// ---- maximum

TEST(Likelihood, ExactDataGiveBackTheConstants) {
  for (const double N0 : {0.0, pretension}) {
    Likelihood l(drum(1, N0, 0), disc(), {true, true, false});
    const LikelihoodMaximum best = most_likely(l);
    ASSERT_TRUE(best.converged) << best.reason;
    // The mean of the kink over the errors of the depth is no kink: a part in ten thousand.
    EXPECT_NEAR(best.theta[0] / Eh, 1, 2e-3);
    EXPECT_NEAR(best.theta[1], N0, 0.02 * pretension);
    EXPECT_NEAR(best.theta[2], 30, 1);
    EXPECT_NEAR(best.theta[3] / sigma_force, 1, 0.05);
  }
}

/// F = σ0h-free line E·h d: what is known of straight lines applies.
const ForceModel line{[](double d, double slope, double) { return ForceAt{slope * d, d, 0}; }};

// Deming's regression (1943): errors in both coordinates of a straight line, its ratio of variances known.
TEST(Likelihood, AStraightLineIsDemings) {
  Normal normal(9);
  CurvePoints p;
  for (int i = 0; i < 60; ++i) {
    const double x = 100 + 2.0 * i;
    p.depth_A.push_back(x + 3 * normal());
    p.force_eV_per_A.push_back(2.5 * x - 40 + 5 * normal());
  }
  p.noise.force_eV_per_A = 5;
  p.noise.depth_A = 3;
  const auto n = static_cast<double>(p.depth_A.size());
  double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  for (std::size_t i = 0; i < p.depth_A.size(); ++i) {
    x += p.depth_A[i] / n;
    y += p.force_eV_per_A[i] / n;
  }
  for (std::size_t i = 0; i < p.depth_A.size(); ++i) {
    xx += std::pow(p.depth_A[i] - x, 2);
    xy += (p.depth_A[i] - x) * (p.force_eV_per_A[i] - y);
    yy += std::pow(p.force_eV_per_A[i] - y, 2);
  }
  const double ratio = 25.0 / 9, difference = yy - ratio * xx;
  const double slope = (difference + std::sqrt(difference * difference + 4 * ratio * xy * xy)) / (2 * xy);

  Likelihood l(p, line, {false, true, false});
  const VectorXd start = Eigen::Vector3d(2, 0, 0);
  l.take_slopes(start);
  LikelihoodMaximum best = maximise(l, start, {1});
  ASSERT_TRUE(best.converged) << best.reason;
  EXPECT_NEAR(best.theta[0] / slope, 1, 1e-8);
  EXPECT_NEAR(best.theta[2], y - slope * x, 1e-5);
}

// A depth z − F/k takes the error of the force along: the error of a line's slope K is (1 + K/k) times as large.
TEST(Likelihood, ErrorsOfForceAndDepthMayBeOne) {
  CurvePoints p;
  double squares = 0;
  for (int i = 1; i <= 20; ++i) {
    p.depth_A.push_back(10.0 * i);
    p.force_eV_per_A.push_back(20.0 * i);
    squares += p.depth_A.back() * p.depth_A.back();
  }
  p.noise.force_eV_per_A = 3;
  p.noise.depth_A = 0;
  p.compliance_A2_per_eV = 1 / 4.0;
  const Likelihood l(p, line, {});
  const Eigen::Vector2d theta(2, 0);
  for (const double miss : l.prediction(theta).miss) EXPECT_NEAR(miss, 0, 1e-6);
  EXPECT_NEAR(std::sqrt(2 / l.at(theta).information(0, 0)), 3 * 1.5 / std::sqrt(squares), 1e-6);
}

// Noise in the force alone is weighted least squares, which GSL does.
TEST(Likelihood, WithNoiseInTheForceAloneIsLeastSquares) {
  const AnyCurveModel form = any_model(Eq16{5000, 0.165});
  CurvePoints p;
  Normal normal(4);
  LeastSquaresOptions options;
  for (int i = 1; i <= 40; ++i) {
    const double truth[] = {Eh, pretension}, sigma = i % 2 ? 2.0 : 5.0;
    p.depth_A.push_back(25.0 * i);
    p.force_eV_per_A.push_back(form.value(p.depth_A.back(), truth) + sigma * normal());
    p.noise.force_weight.push_back(sigma);
    options.weights.push_back(1 / (sigma * sigma));
  }
  p.noise.force_eV_per_A = 1;
  const double start[] = {Eh, 0};
  const LeastSquaresReport squares = least_squares(form, p.depth_A, p.force_eV_per_A, start, options);
  ASSERT_TRUE(squares.converged) << squares.reason;
  Likelihood l(p, force_model(form), {});
  const LikelihoodMaximum best = most_likely(l);
  ASSERT_TRUE(best.converged) << best.reason;
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(best.theta[i] / squares.parameters[static_cast<std::size_t>(i)], 1, 1e-7);
    EXPECT_NEAR(
        std::sqrt(best.covariance(i, i)) * squares.residual_sd / squares.standard_errors[static_cast<std::size_t>(i)],
        1, 1e-6);
  }
}

// A kink among noisy points: nearly each place of it is a minimum. Of fifty curves none may end in one that the noise
// does not make as good as the lowest.
TEST(Likelihood, LeavesNoWrongMinimumOfAContact) {
  const double N0 = 0.7 / N_per_m_per_eV_per_A2;
  for (std::uint32_t seed = 1; seed <= 50; ++seed) {
    Likelihood l(drum(seed, N0), disc(), {true, true, false});
    const LikelihoodMaximum best = most_likely(l);
    ASSERT_TRUE(best.converged) << best.reason;
    const LikelihoodMaximum near_truth = maximise(l, Eigen::Vector4d(Eh, N0, 30, sigma_force));
    EXPECT_LT(best.minus_two_log, near_truth.minus_two_log + 3.84) << seed;
  }
}

TEST(Likelihood, SaysWhatThePointsDoNotDetermine) {
  CurvePoints p;
  p.depth_A = {10, 20, 30, 40};
  p.force_eV_per_A = {20, 41, 59, 80};
  p.noise.force_eV_per_A = 1;
  Likelihood l(p, line, {});
  const LikelihoodMaximum best = maximise(l, Eigen::Vector2d(1.5, 0));
  EXPECT_FALSE(best.converged);
  EXPECT_EQ(best.reason, "the points do not determine the parameters");
}

// ---- intervals

// Unknown noise of a linear model: Student's interval.
TEST(Profile, OfALinearModelIsStudents) {
  const AnyCurveModel form = any_model(Eq16{110, 0.165});
  CurvePoints p;
  Normal normal(3);
  for (int i = 1; i <= 12; ++i) {
    const double truth[] = {20, 0.02};
    p.depth_A.push_back(2.0 * i);
    p.force_eV_per_A.push_back(form.value(p.depth_A.back(), truth) + 0.05 * normal());
  }
  const double start[] = {1, 0};
  const LeastSquaresReport squares = least_squares(form, p.depth_A, p.force_eV_per_A, start);
  Likelihood l(p, force_model(form), {});
  const LikelihoodMaximum best = most_likely(l);
  ASSERT_TRUE(best.converged) << best.reason;
  constexpr double t_10 = 2.228139;  // Student's t, 97.5 %, 10 degrees of freedom (tables)
  for (std::size_t i = 0; i < 2; ++i) {
    const auto ends = profile_interval(l, best, static_cast<int>(i), profile_threshold(l, 0.95));
    EXPECT_NEAR((ends[1] - squares.parameters[i]) / squares.standard_errors[i], t_10, 1e-3);
    EXPECT_NEAR((squares.parameters[i] - ends[0]) / squares.standard_errors[i], t_10, 1e-3);
  }
}

// Where the ends are, the best that all others can do is worse by the threshold.
TEST(Profile, EndsWhereTheLikelihoodHasFallen) {
  Likelihood l(drum(5), disc(), {true, true, false});
  const LikelihoodMaximum best = most_likely(l);
  ASSERT_TRUE(best.converged) << best.reason;
  const double threshold = profile_threshold(l, 0.95);
  EXPECT_NEAR(threshold, 3.841459, 1e-5);  // χ² of one degree of freedom (tables)
  for (const int parameter : {0, 1})
    for (const double end : profile_interval(l, best, parameter, threshold)) {
      VectorXd start = best.theta;
      start[parameter] = end;
      const LikelihoodMaximum other = maximise(l, start, {parameter});
      EXPECT_NEAR((other.minus_two_log - best.minus_two_log) / threshold, best.widening[parameter], 2e-3);
    }
}

// Fuller, Measurement Error Models, 1987, eq. 1.3.12: the slope of a line whose points have errors in both coordinates
// varies as (m v + σ_d² v − β² σ_d⁴)/(n m²), m the variance of the true depths and v = σ_F² + β² σ_d²; the profile
// alone has v/(n m).
TEST(Profile, ErrorsOfTheDepthWidenItAsFullerHas) {
  const ForceModel straight{[](double depth, double slope, double offset) {
    return ForceAt{slope * depth + offset, depth, 1};
  }};
  constexpr int n = 4000;
  constexpr double slope = 2, force_error = 0.5, depth_error = 0.5, length = 3;
  CurvePoints points;
  Normal normal(3);
  for (int i = 0; i < n; ++i) {
    const double depth = 10 + length * i / (n - 1);
    points.depth_A.push_back(depth + depth_error * normal());
    points.force_eV_per_A.push_back(slope * depth + 1 + force_error * normal());
  }
  points.noise.force_eV_per_A = force_error;
  points.noise.depth_A = depth_error;
  Likelihood l(points, straight, {});
  const LikelihoodMaximum best = most_likely(l);
  ASSERT_TRUE(best.converged) << best.reason;
  const double m = length * length / 12, d2 = depth_error * depth_error,
               v = force_error * force_error + slope * slope * d2;
  const double of_profile = v / (n * m), fuller = (m * v + d2 * v - slope * slope * d2 * d2) / (n * m * m);
  EXPECT_NEAR(best.covariance(0, 0) / fuller, 1, 0.05);
  EXPECT_NEAR(best.widening[0] / (fuller / of_profile), 1, 0.03);
  EXPECT_GT(best.widening[0], 1.06);
}

}  // namespace
