// Problems with certified answers through our own fit wrapper: NIST Statistical Reference Datasets, nonlinear
// regression, https://www.itl.nist.gov/div898/strd/nls/nls_main.shtml (Misra1a: lower difficulty, Hahn1:
// average, MGH09 and Thurber: higher). Data, both starting points and certified values are NIST's.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "compare/fitting/fit.hpp"

namespace {

using validate::AnyCurveModel;

struct Problem {
  std::string name;
  AnyCurveModel model;
  std::vector<double> starts[2], certified, certified_sd;
  double residual_sd;
};

/// b1 (1 − exp(−b2 x))
AnyCurveModel misra1a() {
  return {2, [](double x, std::span<const double> b) { return b[0] * (1 - std::exp(-b[1] * x)); },
          [](double x, std::span<const double> b, std::span<double> g) {
            g[0] = 1 - std::exp(-b[1] * x);
            g[1] = b[0] * x * std::exp(-b[1] * x);
          }};
}

/// (b1 + b2 x + b3 x² + b4 x³) / (1 + b5 x + b6 x² + b7 x³): Hahn1 and Thurber
AnyCurveModel cubic_over_cubic() {
  const auto above = [](double x, std::span<const double> b) { return b[0] + x * (b[1] + x * (b[2] + x * b[3])); };
  const auto below = [](double x, std::span<const double> b) { return 1 + x * (b[4] + x * (b[5] + x * b[6])); };
  return {7, [=](double x, std::span<const double> b) { return above(x, b) / below(x, b); },
          [=](double x, std::span<const double> b, std::span<double> g) {
            const double v = below(x, b), u = above(x, b);
            for (int i = 0; i < 4; ++i) g[i] = std::pow(x, i) / v;
            for (int i = 4; i < 7; ++i) g[i] = -std::pow(x, i - 3) * u / (v * v);
          }};
}

/// b1 (x² + x b2) / (x² + x b3 + b4)
AnyCurveModel mgh09() {
  return {4, [](double x, std::span<const double> b) { return b[0] * x * (x + b[1]) / (x * x + x * b[2] + b[3]); },
          [](double x, std::span<const double> b, std::span<double> g) {
            const double u = x * (x + b[1]), v = x * x + x * b[2] + b[3];
            g[0] = u / v;
            g[1] = b[0] * x / v;
            g[2] = -b[0] * u * x / (v * v);
            g[3] = -b[0] * u / (v * v);
          }};
}

const std::vector<Problem>& problems() {
  static const std::vector<Problem> all = {
      {"misra1a",
       misra1a(),
       {{500, 1e-4}, {250, 5e-4}},
       {2.3894212918e+02, 5.5015643181e-04},
       {2.7070075241e+00, 7.2668688436e-06},
       1.0187876330e-01},
      {"hahn1",
       cubic_over_cubic(),
       {{10, -1, 0.05, -1e-5, -0.05, 1e-3, -1e-6}, {1, -0.1, 0.005, -1e-6, -0.005, 1e-4, -1e-7}},
       {1.0776351733e+00, -1.2269296921e-01, 4.0863750610e-03, -1.4262662514e-06, -5.7609940901e-03, 2.4053735503e-04,
        -1.2314450199e-07},
       {1.7070154742e-01, 1.2000289189e-02, 2.2508314937e-04, 2.7578037666e-07, 2.4712888219e-04, 1.0449373768e-05,
        1.3027335327e-08},
       8.1803852243e-02},
      {"mgh09",
       mgh09(),
       {{25, 39, 41.5, 39}, {0.25, 0.39, 0.415, 0.39}},
       {1.9280693458e-01, 1.9128232873e-01, 1.2305650693e-01, 1.3606233068e-01},
       {1.1435312227e-02, 1.9633220911e-01, 8.0842031232e-02, 9.0025542308e-02},
       6.6279236551e-03},
      {"thurber",
       cubic_over_cubic(),
       {{1000, 1000, 400, 40, 0.7, 0.3, 0.03}, {1300, 1500, 500, 75, 1, 0.4, 0.05}},
       {1.2881396800e+03, 1.4910792535e+03, 5.8323836877e+02, 7.5416644291e+01, 9.6629502864e-01, 3.9797285797e-01,
        4.9727297349e-02},
       {4.6647963344e+00, 3.9571156086e+01, 2.8698696102e+01, 5.5675370270e+00, 3.1333340687e-02, 1.4984928198e-02,
        6.5842344623e-03},
       1.3714600784e+01}};
  return all;
}

struct Data {
  std::vector<double> x, y;
};

Data read(const std::string& name) {
  std::ifstream in(std::filesystem::path(NIST_DATA) / (name + ".csv"));
  Data data;
  for (std::string line; std::getline(in, line);) {
    double x, y;
    char comma;
    if (std::istringstream(line) >> x >> comma >> y) data.x.push_back(x), data.y.push_back(y);
  }
  return data;
}

constexpr double digits = 1e-6;  // six of them

class Nist : public testing::TestWithParam<std::tuple<int, int, bool>> {};

TEST_P(Nist, ReachesTheCertifiedValues) {
  const auto& [index, start, geodesic] = GetParam();
  const Problem& problem = problems()[static_cast<std::size_t>(index)];
  const Data data = read(problem.name);
  ASSERT_GT(data.x.size(), 10u);
  const auto report =
      validate::least_squares(problem.model, data.x, data.y, problem.starts[start],
                              {.weights = {}, .geodesic_acceleration = geodesic, .max_iterations = 1000});
  ASSERT_TRUE(report.converged) << report.reason;
  for (std::size_t i = 0; i < problem.certified.size(); ++i) {
    EXPECT_NEAR(report.parameters[i] / problem.certified[i], 1, digits) << i;
    EXPECT_NEAR(report.standard_errors[i] / problem.certified_sd[i], 1, digits) << i;
  }
  EXPECT_NEAR(report.residual_sd / problem.residual_sd, 1, digits);
}

INSTANTIATE_TEST_SUITE_P(Problems, Nist, testing::Combine(testing::Range(0, 4), testing::Range(0, 2), testing::Bool()),
                         [](const auto& test) {
                           return problems()[static_cast<std::size_t>(std::get<0>(test.param))].name + "_start" +
                                  std::to_string(std::get<1>(test.param) + 1) +
                                  (std::get<2>(test.param) ? "_geodesic" : "");
                         });

}  // namespace
