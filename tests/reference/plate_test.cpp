// The sheet with bending, between plate and membrane.
#include "reference/plate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "reference/convergence.hpp"
#include "reference/foppl_disc.hpp"
#include "reference/shallow_tip.hpp"

namespace reference {
namespace {

using std::numbers::pi;

// Kirchhoff: delta = F/(16π D) (1 − c² (¾ + ln 1/c)), Timoshenko & Woinowsky-Krieger, ch. 3.
TEST(PlateReference, IsKirchhoffsWhileShallow) {
  for (const double c : {1e-3, 1.0 / 11, 0.5, 1.0}) {
    const double D = 1e-3, F = 1e-9, linear = F / (16 * pi * D) * (1 - c * c * (0.75 - std::log(c)));
    EXPECT_NEAR(plate({0.3, c, D}, F).centre_depth / linear, 1, 1e-9) << c;
  }
}

TEST(PlateReference, IsTightWhileShallowUnderPretension) {
  for (const double D : {1e-2, 1e-4, 1e-6}) {
    const double F = 1e-10, N0 = 1e-2;
    EXPECT_NEAR(F / plate({0.3, 1e-4, D, N0}, F).centre_depth / tight_plate_stiffness(D, N0), 1, 1e-4) << D;
  }
}

// The closed form joins 16π D to the logarithm of a tight membrane whose tip is as wide as the bending layer:
// ln(l/2) + 0.5772 for ln(a/c) + ½, less the rim's layer, 1/l.
TEST(PlateReference, TightStiffnessHasItsLimits) {
  EXPECT_NEAR(tight_plate_stiffness(1, 1e-4) / (16 * pi), 1, 1e-5);
  const double l = 200;
  EXPECT_NEAR(2 * pi / tight_plate_stiffness(1 / (l * l), 1), std::log(l / 2) + 0.5772156649 - 1 / l, 2 / (l * l));
}

// w0/h + (1 + nu)(173 − 73 nu)/360 (w0/h)³ = F/(64π D h) for uniform pressure: the first two terms of the
// perturbation series of Chien Wei-zang, Chinese J. Phys. 7 (1947) 102.
TEST(PlateReference, BendsOverIntoStretchingAsChienFound) {
  for (const double nu : {0.0, 0.3}) {
    const double D = 1e-4, h = std::sqrt(12 * (1 - nu * nu) * D);
    const auto cubic = [&](double force) {
      const double depth = plate({nu, 1, D}, force).centre_depth / h;
      return (force / (64 * pi * D * h) / depth - 1) / (depth * depth);
    };
    const double coarse = cubic(0.2 * pi * D * 64 * h), fine = cubic(0.1 * pi * D * 64 * h);
    EXPECT_NEAR(fine + (fine - coarse) / 3, (1 + nu) * (173 - 73 * nu) / 360, 1e-4) << nu;
  }
}

// Bending's share of the force is its layers', √D.
TEST(PlateReference, NearsTheMembraneAsBendingVanishes) {
  const double force = 1e-2, c = 1.0 / 11, membrane = foppl_disc({0.19, c}, force).centre;
  const auto excess = [&](double D) { return std::pow(membrane / plate({0.19, c, D}, force).centre_depth, 3) - 1; };
  const double coarse = excess(1e-7), fine = excess(1e-9);
  EXPECT_GT(fine, 0);
  EXPECT_LT(fine, 5e-4);
  EXPECT_NEAR(coarse / fine, 10, 0.5);
  const FopplDepth tight = foppl_disc({0.19, c, 1e-3}, force);
  const PlateState thin = plate({0.19, c, 1e-9, 1e-3}, force);
  EXPECT_NEAR(thin.centre_depth / tight.centre, 1, 2e-4);
  EXPECT_NEAR(thin.conjugate_depth / tight.conjugate, 1, 2e-4);
  EXPECT_NEAR(thin.rim_force / tight.rim_force, 1, 1e-3);
}

TEST(PlateReference, DoesAsMuchWorkAsItStores) {
  const Plate sheet{0.19, 1.0 / 11, 1e-5, 1e-3};
  const double force = 2e-3;
  const auto remainder = [&](double share) {
    const PlateState less = plate(sheet, force * (1 - share)), more = plate(sheet, force * (1 + share));
    return (more.energy - less.energy) / (more.conjugate_depth - less.conjugate_depth) / force - 1;
  };
  EXPECT_LT(std::abs(remainder(0.02)), 1e-3);
  EXPECT_NEAR(remainder(0.04) / remainder(0.02), 4, 0.05);
}

TEST(PlateReference, Converges) {
  const auto depth = [](int steps) { return plate({0.19, 1.0 / 11, 1e-6}, 1e-2, steps).centre_depth; };
  testing::expect_converges(depth, 50, 3.7, 1e-12);
  testing::expect_settled(depth, 400, 1e-8);
}

}  // namespace
}  // namespace reference
