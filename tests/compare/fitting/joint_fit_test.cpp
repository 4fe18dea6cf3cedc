// Many curves with one E·h, against what is known of straight lines, and means with a spread.
#include "compare/fitting/joint_fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "compare/fitting/normal.hpp"
#include "compare/fitting/spread_mean.hpp"

namespace {

using namespace validate;

constexpr double Eh = 20, sigma = 3;

/// F = E·h d + N0 d²: linear in both, so that everything is weighted least squares.
const ForceModel plane{[](double d, double e, double n) { return ForceAt{e * d + n * d * d, d, d * d}; }};

void one_by_one(std::size_t n, const std::function<void(std::size_t)>& work) {
  for (std::size_t i = 0; i < n; ++i) work(i);
}

CurvePoints points_of(int curve) {
  Normal normal(static_cast<std::uint32_t>(curve + 1));
  CurvePoints p;
  for (int i = 1; i <= 30 + 10 * curve; ++i) {
    const double d = 0.5 * i;
    p.depth_A.push_back(d);
    p.force_eV_per_A.push_back(Eh * d + (1 + curve) * d * d + sigma * normal());
  }
  p.noise.force_eV_per_A = sigma;
  return p;
}

std::vector<JointCurve> curves_of(int count, double input_error, const char* input) {
  std::vector<JointCurve> curves;
  for (int i = 0; i < count; ++i) {
    std::vector<UncertainInput> inputs;
    if (input_error > 0) inputs.push_back({input, scaled(plane, 1 + input_error)});
    Likelihood alone(points_of(i), plane, {}), likelihood(points_of(i), plane, {}, inputs);
    const LikelihoodMaximum best = most_likely(alone);
    EXPECT_TRUE(best.converged) << best.reason;
    Eigen::VectorXd start = Eigen::VectorXd::Zero(likelihood.parameter_count());
    start.head(2) = best.theta.head(2);
    curves.push_back({likelihood, start, i});
  }
  return curves;
}

/// Information on E·h of one curve when its other constant is sought too.
double information_of(int curve) {
  double dd = 0, ddd = 0, dddd = 0;
  for (const double d : points_of(curve).depth_A) dd += d * d, ddd += d * d * d, dddd += d * d * d * d;
  return (dd - ddd * ddd / dddd) / (sigma * sigma);
}

TEST(JointFit, OfLinesIsTheirWeightedMean) {
  const std::vector<JointCurve> curves = curves_of(4, 0, "");
  double weight = 0, mean = 0;
  for (int i = 0; i < 4; ++i) {
    weight += information_of(i);
    mean += information_of(i) * curves[static_cast<std::size_t>(i)].start[0];
  }
  const JointOutcome joint = joint_fit(curves, 0, one_by_one);
  ASSERT_EQ(joint.reason, "");
  EXPECT_NEAR(joint.fit.Eh_eV_per_A2, mean / weight, 1e-6);
  EXPECT_NEAR(joint.fit.Eh_stderr_eV_per_A2 * std::sqrt(weight), 1, 1e-6);
  EXPECT_EQ(joint.fit.sources.front().name, "noise");
  EXPECT_TRUE(joint.fit.sources.front().falls);
}

// An error of the force's scale is in every curve: it stays, however many there are.
TEST(JointFit, ASharedErrorDoesNotFall) {
  for (const int count : {2, 6}) {
    const JointFit fit = joint_fit(curves_of(count, 0.05, "spring constant"), 0, one_by_one).fit;
    const auto source = std::ranges::find(fit.sources, "spring constant", &JointSource::name);
    ASSERT_NE(source, fit.sources.end());
    EXPECT_NEAR(source->Eh_eV_per_A2 / Eh, 0.05, 0.002) << count;
    EXPECT_FALSE(source->falls);
    EXPECT_GT(fit.Eh_stderr_eV_per_A2, 0.048 * Eh);
  }
}

// Every drum has its own radius: with four drums its error is half.
TEST(JointFit, TheRadiusIsTheDrumsOwn) {
  const auto error = [](int count) {
    const JointFit fit = joint_fit(curves_of(count, 0.05, "radius"), 0, one_by_one).fit;
    return fit.Eh_stderr_eV_per_A2;
  };
  EXPECT_NEAR(error(4) / error(1), 0.5, 0.03);
}

TEST(SpreadMean, WithoutASpreadIsTheWeightedMean) {
  const RandomEffects m = random_effects({10, 10.5, 9.8}, {1, 2, 0.5});
  const double weight = 1 + 0.25 + 4;
  EXPECT_NEAR(m.mean, (10 + 10.5 * 0.25 + 9.8 * 4) / weight, 1e-12);
  EXPECT_NEAR(m.standard_error, 1 / std::sqrt(weight), 1e-12);
  EXPECT_EQ(m.between, 0);
}

// With equal errors τ² + s² is the sample's variance.
TEST(SpreadMean, FindsTheSpreadBehindTheNoise) {
  Normal normal(5);
  std::vector<double> values, errors(400, 1.0);
  double sum = 0, squares = 0;
  for (int i = 0; i < 400; ++i) {
    values.push_back(50 + std::hypot(1.0, 2.0) * normal());
    sum += values.back();
  }
  for (const double value : values) squares += std::pow(value - sum / 400, 2);
  const RandomEffects m = random_effects(values, errors);
  EXPECT_NEAR(m.mean, sum / 400, 1e-9);
  EXPECT_NEAR(m.between * m.between + 1, squares / 399, 1e-6);
  EXPECT_NEAR(m.within, 1, 1e-12);
}

CurveRow row(const char* file, double modulus) {
  CurveRow r{.file = file};
  r.Eh_eV_per_A2 = modulus;
  r.Eh_noise_eV_per_A2 = r.pretension_stderr_eV_per_A2 = 0.1;
  r.pretension_eV_per_A2 = 1;
  return r;
}

TEST(SpreadMean, OfDrumsCountsEachOnceAndLeavesTheSkippedOut) {
  std::vector<CurveRow> rows = {row("a", 10), row("a", 10), row("a", 10), row("b", 20), row("a", 1000)};
  rows.back().skipped = "slip or break";
  const std::vector<SpreadMean> means = spread_means(rows);
  ASSERT_EQ(means.size(), 2u);
  EXPECT_EQ(means[0].count, 4);
  EXPECT_EQ(means[1].count, 2);
  EXPECT_NEAR(means[0].Eh_eV_per_A2, 12.5, 0.01);
  EXPECT_NEAR(means[1].Eh_eV_per_A2, 15, 0.01);
  EXPECT_NEAR(means[1].Eh_between_eV_per_A2, std::sqrt(50), 0.01);
}

}  // namespace
