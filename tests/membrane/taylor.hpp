// Derivatives judged by the order at which the Taylor remainder falls, not by one epsilon.
#pragma once

#include <gtest/gtest.h>

#include <cmath>

namespace membrane::testing {

/// remainder(t): norm of f(x + t v) minus its Taylor polynomial at x; it must fall as t^order where the
/// derivatives are right (one order less where the last of them is wrong). `noise` is the size of rounding;
/// a remainder below it proves the polynomial exact.
template <class Remainder>
void expect_order(Remainder remainder, double step, int order, double noise) {
  const double coarse = remainder(step);
  const double fine = remainder(step / 4);
  if (coarse <= noise) return;
  ASSERT_GT(fine, 0);
  EXPECT_NEAR(std::log2(coarse / fine) / 2, order, 0.15) << "remainders " << coarse << " and " << fine;
}

}  // namespace membrane::testing
