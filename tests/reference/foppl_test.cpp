// Föppl–von Kármán membranes under a point or a disc.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "reference/convergence.hpp"
#include "reference/foppl_disc.hpp"
#include "reference/foppl_point.hpp"

namespace reference {
namespace {

using std::numbers::pi;

TEST(FopplPoint, IsSchwerinsSolutionAtOneThird) {
  const PointLoad load = foppl_point(1.0 / 3);
  EXPECT_NEAR(load.alpha, pi / 3, 1e-14);
  EXPECT_NEAR(load.beta, 2.0 / 3, 1e-14);
  EXPECT_NEAR(load.rim_force, 0.25, 1e-14);  // E·h/(1 − nu²) w'²/2 with w' = 2 delta/(3 a)
}

// The same equation solved elsewhere, five and four digits.
TEST(FopplPoint, AgreesWithPublishedFactors) {
  EXPECT_NEAR(foppl_point(0.165).alpha, 0.93770, 5e-6);
  EXPECT_NEAR(foppl_point(0.19).alpha, 0.95155, 5e-6);
  EXPECT_NEAR(foppl_point(0.3).alpha, 1.02206, 5e-6);
  EXPECT_NEAR(foppl_point(0.165).beta, 0.6925, 5e-5);
  EXPECT_NEAR(foppl_point(0.19).beta, 0.6889, 5e-5);
}

// Komaragiri, Begley, Simmonds, J. Appl. Mech. 72 (2005) 203, fit 1/(1.05 − 0.15 nu − 0.16 nu²)³ to within 1
// %.
TEST(FopplPoint, IsWithinOnePercentOfTheUsualFit) {
  for (const double nu : {0.0, 0.1, 0.2, 0.3, 0.4, 0.45}) {
    const double q = 1 / (1.05 - 0.15 * nu - 0.16 * nu * nu);
    EXPECT_NEAR(foppl_point(nu).alpha / (q * q * q), 1, 0.011) << nu;
  }
}

TEST(FopplPoint, IsSmoothThroughOneThird) {
  for (const double step : {1e-2, 1e-3}) {
    const double mean = (foppl_point(1.0 / 3 - step).alpha + foppl_point(1.0 / 3 + step).alpha) / 2;
    EXPECT_NEAR(mean, pi / 3, step * step);
  }
}

TEST(FopplPoint, Converges) {
  for (const double nu : {-0.158, 0.0, 0.19, 0.45}) {
    const auto alpha = [nu](int steps) { return foppl_point(nu, steps).alpha; };
    testing::expect_converges(alpha, 20, 6, 1e-12);
    testing::expect_settled(alpha, 400, 1e-11);
  }
}

double alpha(const FopplDisc& disc, int steps = 100) { return std::pow(foppl_disc(disc, 1, steps).centre, -3); }

TEST(FopplDisc, AgreesWithFactorsComputedElsewhere) {
  EXPECT_NEAR(alpha({0.19, 0.01}), 1.02773, 5e-6);
  EXPECT_NEAR(alpha({0.19, 0.05}), 1.19889, 5e-6);
  EXPECT_NEAR(alpha({0.19, 10.0 / 110}), 1.35188, 5e-6);
}

TEST(FopplDisc, NearsThePointLoadAsTheDiscShrinks) {
  const double point = foppl_point(0.19).alpha;
  const auto excess = [point](double c) { return alpha({0.19, c}) / point - 1; };
  EXPECT_GT(excess(1e-5), 0);
  // By (c/a)^(2/3), and its square.
  EXPECT_NEAR(excess(8e-3) / excess(1e-3), 4, 0.2);
  EXPECT_NEAR(excess(8e-5) / excess(1e-5), 4, 0.2 / 16);
}

// The limit of the disc, the powers 2/3 and 4/3 of c/a taken out, is the point load solved in its own way.
TEST(FopplDisc, ExtrapolatesToThePointLoad) {
  for (const double nu : {-0.158, 0.0, 0.165, 0.3}) {
    const double coarse = alpha({nu, 6.4e-3}), middle = alpha({nu, 8e-4}), fine = alpha({nu, 1e-4});
    const double first = middle + (middle - coarse) / 3, second = fine + (fine - middle) / 3;
    EXPECT_NEAR((second + (second - first) / 15) / foppl_point(nu).alpha, 1, 2e-6) << nu;
  }
}

TEST(FopplDisc, TakesPretensionAsTheEnergyArgumentSays) {
  // From two small pretensions the term of second order is taken out.
  const double c = 1e-4, delta = 1e-2, nu = 0.19;
  const auto force = [&](double N0) {
    double F = delta * delta * delta;
    for (int i = 0; i < 40; ++i) F *= std::pow(delta / foppl_disc({nu, c, N0}, F).centre, 2.5);
    return F;
  };
  const double scale = 1e-3 * delta * delta, none = force(0);
  const double once = (force(scale) - none) / (pi * scale * delta);
  const double twice = (force(2 * scale) - none) / (2 * pi * scale * delta);
  EXPECT_NEAR(2 * once - twice, foppl_point(nu).beta, 3e-3);  // c/a = 1e-4 is 0.3 % away from the point
}

TEST(FopplDisc, DepthsGrowWithTheCubeRootOfTheForce) {
  const FopplDepth weak = foppl_disc({0.3, 0.2}, 1e-6), strong = foppl_disc({0.3, 0.2}, 1e-3);
  EXPECT_NEAR(strong.centre / weak.centre, 10, 1e-9);
  EXPECT_NEAR(strong.conjugate / weak.conjugate, 10, 1e-9);
}

TEST(FopplDisc, Converges) {
  testing::expect_converges([](int steps) { return alpha({0.19, 0.05}, steps); }, 16, 6, 1e-12);
  testing::expect_settled([](int steps) { return alpha({0.19, 0.05}, steps); }, 100, 1e-11);
  testing::expect_settled([](int steps) { return alpha({0.19, 1e-3}, steps); }, 100, 1e-9);
}

}  // namespace
}  // namespace reference
