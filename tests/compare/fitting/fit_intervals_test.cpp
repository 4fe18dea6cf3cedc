#include "compare/fitting/fit_intervals.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "compare/fitting/models/eq16.hpp"

using namespace validate;

namespace {

const AnyCurveModel model = any_model(Eq16{110, 0.165});
constexpr double truth[] = {20, 0.02}, start[] = {1, 0};

std::vector<double> depths(int n) {
  std::vector<double> d;
  for (int i = 1; i <= n; ++i) d.push_back(24.0 * i / n);
  return d;
}

std::vector<double> noisy(const std::vector<double>& d, unsigned seed, double sd = 0.05) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, sd);
  std::vector<double> f;
  for (const double depth : d) f.push_back(model.value(depth, truth) + noise(random));
  return f;
}

TEST(Profile, OfALinearModelIsTheTInterval) {
  const auto d = depths(12), f = noisy(d, 3);
  const auto report = least_squares(model, d, f, start);
  const auto intervals = profile_intervals(model, d, f, report, {});
  constexpr double t_10 = 2.228139;  // Student's t, 97.5 %, 10 degrees of freedom (tables)
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR((intervals[i][1] - report.parameters[i]) / report.standard_errors[i], t_10, 1e-5);
    EXPECT_NEAR((report.parameters[i] - intervals[i][0]) / report.standard_errors[i], t_10, 1e-5);
  }
}

// y = exp(−p x): a curved model has a crooked interval. The ends are where the sum of squares is at the
// limit.
TEST(Profile, OfACurvedModelEndsAtTheLimit) {
  const AnyCurveModel decay{
      1, [](double x, std::span<const double> p) { return std::exp(-p[0] * x); },
      [](double x, std::span<const double> p, std::span<double> g) { g[0] = -x * std::exp(-p[0] * x); }};
  const std::vector<double> x = {0.5, 1, 2, 4}, y = {0.7, 0.3, 0.2, 0.1};
  const double one[] = {1};
  const auto report = least_squares(decay, x, y, one);
  ASSERT_TRUE(report.converged);
  const Interval interval = profile_intervals(decay, x, y, report, {}).front();
  constexpr double t_3 = 3.182446;
  for (const double end : interval) {
    double sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i) sum += std::pow(y[i] - std::exp(-end * x[i]), 2);
    EXPECT_NEAR(sum / (report.sum_of_squares * (1 + t_3 * t_3 / 3)), 1, 1e-5);
  }
  EXPECT_GT(interval[1] - report.parameters[0], 1.05 * (report.parameters[0] - interval[0]));
}

TEST(Bootstrap, ErrorsAreThoseOfTheCovariance) {
  const auto d = depths(40), f = noisy(d, 11);
  const auto report = least_squares(model, d, f, start);
  const Bootstrap drawn = bootstrap(model, d, report, {}, 2000, 7);
  EXPECT_EQ(drawn.samples, 2000);
  for (int i = 0; i < 2; ++i) {  // 2000 draws: 1.6 % of a standard error, four times
    EXPECT_NEAR(drawn.standard_errors[i] / report.standard_errors[i], 1, 0.065);
    EXPECT_LT(drawn.intervals[i][0], report.parameters[i]);
    EXPECT_GT(drawn.intervals[i][1], report.parameters[i]);
  }
}

TEST(Bootstrap, TheSeedDecides) {
  const auto d = depths(12), f = noisy(d, 3);
  const auto report = least_squares(model, d, f, start);
  const auto a = bootstrap(model, d, report, {}, 50, 7), b = bootstrap(model, d, report, {}, 50, 7),
             c = bootstrap(model, d, report, {}, 50, 8);
  EXPECT_EQ(a.standard_errors, b.standard_errors);
  EXPECT_NE(a.standard_errors, c.standard_errors);
}

TEST(Offsets, AreRecovered) {
  const auto d = depths(40);
  std::vector<double> f;
  for (const double depth : d) f.push_back(model.value(depth - 1.5, truth) + 0.3);
  const AnyCurveModel shifted = with_offsets(model, true, true);
  ASSERT_EQ(shifted.parameter_count, 4);
  const double from[] = {10, 0, 0, 0};
  const auto report = least_squares(shifted, d, f, from);
  ASSERT_TRUE(report.converged) << report.reason;
  const double expected[] = {20, 0.02, 1.5, 0.3};
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(report.parameters[i], expected[i], 1e-5 * expected[i]) << i;
}

TEST(Offsets, GradientIsTheValuesDerivative) {
  const AnyCurveModel shifted = with_offsets(model, true, true);
  const double at[] = {20, 0.02, 1.5, 0.3};
  double gradient[4];
  for (const double depth : {1.5, 3.0, 20.0}) {
    shifted.gradient(depth, at, gradient);
    for (int i = 0; i < 4; ++i) {
      double up[] = {at[0], at[1], at[2], at[3]}, down[] = {at[0], at[1], at[2], at[3]};
      up[i] += 1e-4;
      down[i] -= 1e-4;
      EXPECT_NEAR(gradient[i], (shifted.value(depth, up) - shifted.value(depth, down)) / 2e-4, 1e-5);
    }
  }
}

}  // namespace
