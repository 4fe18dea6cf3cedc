#include "compare/fitting/even_spline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace validate;

namespace {

struct Sampled {
  EvenSteps steps;
  EvenSpline spline;
  explicit Sampled(std::size_t count, double (*f)(double)) : steps{0.5, 3.0 / static_cast<double>(count - 1), count} {
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) values.push_back(f(steps.first + static_cast<double>(i) * steps.step));
    spline = EvenSpline(steps, values);
  }
  SplineAlong along(double x) const { return spline.along(steps.place(x)); }
};

double wave(double x) { return std::sin(2 * x); }

// Away from the ends, where a natural spline is wrong, the error falls with the fourth power of the step.
TEST(EvenSpline, ErrorIsOfFourthOrder) {
  const auto error = [](std::size_t count) {
    const Sampled sampled(count, wave);
    double most = 0;
    for (double x = 1.5; x < 2.5; x += 0.003) most = std::max(most, std::abs(sampled.along(x).value - wave(x)));
    return most;
  };
  EXPECT_NEAR(std::log2(error(61) / error(121)), 4, 0.3);
}

TEST(EvenSpline, GoesThroughItsValuesAndHasNoCurvatureAtTheEnds) {
  const Sampled sampled(7, wave);
  for (int i = 0; i < 7; ++i) EXPECT_NEAR(sampled.along(0.5 + 0.5 * i).value, wave(0.5 + 0.5 * i), 1e-14);
  EXPECT_NEAR(sampled.along(0.5).second, 0, 1e-14);
  EXPECT_NEAR(sampled.along(3.5).second, 0, 1e-14);
}

TEST(EvenSpline, DerivativesAreThoseOfTheValues) {
  const Sampled sampled(9, wave);
  const double h = 1e-4;
  for (double x = 0.61; x < 3.4; x += 0.1) {
    const SplineAlong up = sampled.along(x + h), at = sampled.along(x), down = sampled.along(x - h);
    EXPECT_NEAR(at.first, (up.value - down.value) / (2 * h), 1e-7);
    EXPECT_NEAR(at.second, (up.first - down.first) / (2 * h), 1e-7);
  }
}

TEST(EvenSpline, ASumIsTheSplineOfTheSum) {
  const Sampled a(9, wave), b(9, [](double x) { return x * x; }), both(9, [](double x) { return 2 * wave(x) - x * x; });
  EvenSpline sum;
  sum.add(2, a.spline);
  sum.add(-1, b.spline);
  for (double x = 0.5; x < 3.5; x += 0.07) {
    EXPECT_NEAR(sum.along(a.steps.place(x)).value, both.along(x).value, 1e-13);
    EXPECT_NEAR(sum.along(a.steps.place(x)).second, both.along(x).second, 1e-12);
  }
}

TEST(EvenSpline, OutsideIsTheEnd) {
  const Sampled sampled(9, wave);
  EXPECT_EQ(sampled.along(0).value, sampled.along(0.5).value);
  EXPECT_EQ(sampled.along(9).value, sampled.along(3.5).value);
}

}  // namespace
