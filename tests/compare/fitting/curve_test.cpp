#include "compare/fitting/curve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using validate::Curve;

namespace {

TEST(Curve, IsExactForAPowerLaw) {
  const std::vector<double> depth = {1, 2, 4, 7, 11}, force = {1, 8, 64, 343, 1331};
  const Curve curve(depth, force);
  for (const double d : {1.0, 1.5, 3.0, 5.123, 10.0, 11.0}) {
    ASSERT_TRUE(curve.at(d)) << d;
    EXPECT_NEAR(*curve.at(d) / (d * d * d), 1, 1e-12) << d;
  }
}

TEST(Curve, NeverExtrapolates) {
  const Curve curve(std::vector{2.0, 3.0, 5.0}, std::vector{1.0, 2.0, 9.0});
  EXPECT_DOUBLE_EQ(curve.lowest_A(), 2);
  EXPECT_DOUBLE_EQ(curve.highest_A(), 5);
  EXPECT_TRUE(curve.at(2.0));
  EXPECT_TRUE(curve.at(5.0));
  for (const double outside : {1.999, 5.001, 0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_FALSE(curve.at(outside)) << outside;
  }
}

TEST(Curve, StaysMonotoneAcrossAStep) {
  const std::vector<double> depth = {1, 2, 3, 4, 5, 6}, force = {1, 1.01, 1.02, 9, 9.01, 9.02};
  const Curve curve(depth, force);
  double before = 0;
  for (double d = 1; d <= 6; d += 0.01) {
    const double f = *curve.at(d);
    EXPECT_GE(f, before) << d;
    EXPECT_LE(f, 9.02 * (1 + 1e-12)) << d;
    before = f;
  }
}

TEST(Curve, TakesAnyOrderAndTwoPoints) {
  const Curve curve(std::vector{4.0, 1.0}, std::vector{64.0, 1.0});
  EXPECT_NEAR(*curve.at(2), 8, 1e-12);
}

TEST(Curve, RefusesWhatHasNoLogarithm) {
  const std::vector<double> depth = {1, 2, 3};
  EXPECT_THROW(Curve(depth, std::vector{1.0, 0.0, 3.0}), std::invalid_argument);
  EXPECT_THROW(Curve(depth, std::vector{1.0, -2.0, 3.0}), std::invalid_argument);
  EXPECT_THROW(Curve(depth, std::vector{1.0, 2.0}), std::invalid_argument);
  EXPECT_THROW(Curve(std::vector{2.0, 2.0}, std::vector{1.0, 1.0}), std::invalid_argument);
}

TEST(Curve, OfARunUsesItsUsablePoints) {
  validate::Run run;
  run.depth_A = {1, 2, 3, 4};
  run.force_eV_per_A = {1, 8, 1000, 64};
  run.converged = {true, true, false, true};
  EXPECT_NEAR(*Curve(run).at(3), 27, 1e-9);
}

}  // namespace
