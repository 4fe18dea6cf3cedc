// A sheet and a cantilever in series.
#include "compare/fitting/cantilever.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace validate;

/// F = N d + E d³, by its formulas.
ForceCurve cubic(double E, double N) {
  return [=](double d) {
    return ForceAlong{{N * d + E * d * d * d, d * d * d, d}, {N + 3 * E * d * d, 3 * d * d, 1}, 6 * E * d};
  };
}

constexpr double k = 0.7, E = 0.02, N = 0.3;

TEST(Cantilever, ALineIsTwoSpringsInSeries) {
  ForceCurve both = in_series(cubic(0, N), 1 / k);
  for (const double z : {0.1, 1.0, 25.0}) {
    EXPECT_NEAR(both(z).value.force, z * N * k / (N + k), 1e-9 * z);
    EXPECT_NEAR(both(z).first.force, N * k / (N + k), 1e-9);
  }
}

// In order, back and forth, and far from the place before.
TEST(Cantilever, TheForceIsTheSheetsAtItsDepth) {
  ForceCurve both = in_series(cubic(E, N), 1 / k);
  for (const double z : {0.01, 0.1, 0.2, 5.0, 5.1, 5.2, 40.0, 1.0, 0.001, 39.0}) {
    const double force = both(z).value.force, depth = z - force / k;
    EXPECT_NEAR(force / (N * depth + E * depth * depth * depth), 1, 1e-8) << z;
  }
}

// Central differences of forces that are right to 1e-12: what is left falls with the square of the step.
TEST(Cantilever, DerivativesAreThoseOfTheForce) {
  const auto force = [](double z, double e, double n) { return in_series(cubic(e, n), 1 / k)(z).value.force; };
  for (const double z : {0.5, 8.0, 60.0}) {
    const ForceAlong at = in_series(cubic(E, N), 1 / k)(z);
    const double h = 1e-3 * z, dE = 1e-3 * E, dN = 1e-3 * N;
    EXPECT_NEAR((force(z + h, E, N) - force(z - h, E, N)) / (2 * h) / at.first.force, 1, 1e-5);
    EXPECT_NEAR((force(z, E + dE, N) - force(z, E - dE, N)) / (2 * dE) / at.value.by_Eh, 1, 1e-5);
    EXPECT_NEAR((force(z, E, N + dN) - force(z, E, N - dN)) / (2 * dN) / at.value.by_pretension, 1, 1e-5);
    const ForceAlong up = in_series(cubic(E, N), 1 / k)(z + h), down = in_series(cubic(E, N), 1 / k)(z - h);
    EXPECT_NEAR((up.first.force - down.first.force) / (2 * h) / at.second, 1, 1e-3);
    EXPECT_NEAR((up.value.by_Eh - down.value.by_Eh) / (2 * h) / at.first.by_Eh, 1, 1e-4);
    EXPECT_NEAR((up.value.by_pretension - down.value.by_pretension) / (2 * h), at.first.by_pretension, 1e-4);
  }
}

TEST(Cantilever, ASheetThatPullsItselfInHasNoPlace) {
  EXPECT_TRUE(std::isnan(in_series(cubic(0, -2 * k), 1 / k)(1.0).value.force));
}

}  // namespace
