// A problem with certified answers through our own fit wrapper.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "compare/fit.hpp"

namespace {

// NIST Statistical Reference Datasets, nonlinear regression, Misra1a (Misra, NIST 1978, dental research
// monomolecular adsorption): https://www.itl.nist.gov/div898/strd/nls/data/misra1a.shtml. y = b1 (1 − exp(−b2
// x)).
struct Misra1a {
  static constexpr int parameter_count = 2;

  double value(double x, std::span<const double> b) const { return b[0] * (1 - std::exp(-b[1] * x)); }
  void gradient(double x, std::span<const double> b, std::span<double> g) const {
    g[0] = 1 - std::exp(-b[1] * x);
    g[1] = b[0] * x * std::exp(-b[1] * x);
  }
};

constexpr std::array x = {77.6,  114.9, 141.1, 190.8, 239.9, 289.0, 332.8,
                          378.4, 434.8, 477.3, 536.8, 593.1, 689.1, 760.0};
constexpr std::array y = {10.07, 14.73, 17.94, 23.93, 29.61, 35.18, 40.02,
                          44.82, 50.76, 55.05, 61.01, 66.40, 75.47, 81.78};

// Certified: parameters, their standard deviations, residual standard deviation. Six digits are asked for.
constexpr std::array certified = {2.3894212918e+02, 5.5015643181e-04};
constexpr std::array certified_sd = {2.7070075241e+00, 7.2668688436e-06};
constexpr double certified_residual_sd = 1.0187876330e-01;
constexpr double digits = 1e-6;

class NistMisra1a : public testing::TestWithParam<std::tuple<std::array<double, 2>, bool>> {};

TEST_P(NistMisra1a, ReachesTheCertifiedValues) {
  const auto& [start, geodesic] = GetParam();
  const auto report =
      compare::least_squares(Misra1a{}, x, y, start, {.weights = {}, .geodesic_acceleration = geodesic});
  ASSERT_TRUE(report.converged) << report.reason;
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(report.parameters[i] / certified[i], 1, digits);
    EXPECT_NEAR(report.standard_errors[i] / certified_sd[i], 1, digits);
  }
  EXPECT_NEAR(report.residual_sd / certified_residual_sd, 1, digits);
}

// Both of NIST's starting points; the first is the far one.
INSTANTIATE_TEST_SUITE_P(Starts, NistMisra1a,
                         testing::Combine(testing::Values(std::array{500.0, 1e-4}, std::array{250.0, 5e-4}),
                                          testing::Bool()));

}  // namespace
