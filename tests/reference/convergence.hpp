// A solver held to its own convergence.
#pragma once

#include <gtest/gtest.h>

#include <cmath>

namespace reference::testing {

/// solve(steps) -> number. From `coarse` steps on, each halving of the step must take at least `order` powers
/// of two off the error (order 8 by theory, 7 leaves room for the pre-asymptotic start), unless it is at
/// `rounding`, relative, already.
template <class Solve>
void expect_converges(Solve solve, int coarse, double order, double rounding) {
  const double best = solve(8 * coarse);
  const double first = std::abs(solve(coarse) / best - 1), second = std::abs(solve(2 * coarse) / best - 1);
  EXPECT_LE(second, std::max(first * std::pow(2, -order), rounding)) << "after an error of " << first;
  EXPECT_GT(first, rounding) << "too fine a start to show an order";
}

/// The default number of steps leaves an error below `tolerance`, relative, as four times as many tell.
template <class Solve>
void expect_settled(Solve solve, int steps, double tolerance) {
  const double best = solve(4 * steps);
  EXPECT_LE(std::abs(solve(steps) / best - 1), tolerance) << "value " << best;
}

}  // namespace reference::testing
