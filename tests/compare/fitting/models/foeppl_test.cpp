// The shallow disc against closed forms and published coefficients.
#include "compare/fitting/models/foeppl.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace validate;
using std::numbers::pi;

namespace {

double alpha(double nu, double tip) {
  const double depth = depth_under({nu, tip, 0}, 1, 0);
  return 1 / (depth * depth * depth);
}

TEST(Foeppl, PointLoadAtOneThirdIsSchwerins) { EXPECT_NEAR(alpha(1.0 / 3, 0), pi / 3, 1e-6); }

TEST(Foeppl, CoefficientsOfPointAndDisc) {
  // Computed with codes written separately (one-dimensional shooting); half of the last digit, and 1e-5.
  EXPECT_NEAR(alpha(0, 0), 0.86099, 1.5e-5);
  EXPECT_NEAR(alpha(0.165, 0), 0.93770, 1e-5);
  EXPECT_NEAR(alpha(0.19, 0), 0.95155, 1e-5);
  EXPECT_NEAR(alpha(0.3, 0), 1.02206, 1e-5);
  EXPECT_NEAR(alpha(0.19, 0.01), 1.02773, 1e-5);
  EXPECT_NEAR(alpha(0.19, 0.05), 1.19889, 1e-5);
  EXPECT_NEAR(alpha(0.19, 10.0 / 110), 1.35188, 1e-5);
}

TEST(Foeppl, UniformPressureIsHenckys) {
  // w0 = C a (p a/E·h)^{1/3}; Hencky 1915 with Campbell's corrected series (Q. J. Mech. Appl. Math. 9 (1956)
  // 84).
  const auto C = [](double nu) { return std::cbrt(pi / alpha(nu, 1)); };
  EXPECT_NEAR(C(0.3), 0.653443, 1e-6);
  EXPECT_NEAR(C(0.19), 0.679687, 1e-6);
}

TEST(Foeppl, PretensionAtFirstOrder) {
  EXPECT_NEAR(FoepplCurve(1.0 / 3, 0).beta(), 2.0 / 3, 2e-6);  // exact
  EXPECT_NEAR(FoepplCurve(0.165, 0).beta(), 0.6925, 5e-5);
  EXPECT_NEAR(FoepplCurve(0.19, 0).beta(), 0.6889, 5e-5);
}

TEST(Foeppl, PretensionAloneIsLaplaces) {
  for (const double tip : {0.01, 0.1}) {
    const double pretension = 1, force = 1e-4;  // depth² far below the pretension
    EXPECT_NEAR(force / depth_under({0.165, tip, 0}, force, pretension) / (2 * pi / (std::log(1 / tip) + 0.5)), 1,
                1e-6);
  }
}

TEST(Foeppl, BendingAloneIsTheClampedPlate) {
  // Timoshenko & Woinowsky-Krieger § 19: w(0) = F (4a² − 4c² ln(a/c) − 3c²)/(64 π κ).
  const double kappa = 1e-4, force = 1e-7;
  for (const double c : {0.0, 0.1, 0.5}) {
    const double shape = c > 0 ? 4 - 4 * c * c * std::log(1 / c) - 3 * c * c : 4;
    EXPECT_NEAR(depth_under({0.3, c, kappa}, force, 0) / (force * shape / (64 * pi * kappa)), 1, 2e-6) << c;
  }
}

TEST(Foeppl, BendingFadesAway) {
  const double without = depth_under({0.19, 0.1, 0}, 0.02, 0);
  double last = 1;
  for (const double kappa : {1e-3, 1e-4, 1e-5, 1e-6}) {
    const double missing = 1 - depth_under({0.19, 0.1, kappa}, 0.02, 0) / without;
    EXPECT_GT(missing, 0);
    EXPECT_LT(missing, 0.6 * last);
    last = missing;
  }
}

TEST(Foeppl, DepthConvergesWithTheSquareOfTheSpacing) {
  for (const FoepplDisc& disc : {FoepplDisc{0.19, 0.1, 0}, FoepplDisc{0.19, 0, 0}, FoepplDisc{0.19, 0.1, 1e-4}}) {
    const double exact = depth_under(disc, 0.02, 0.001);
    const double coarse = solve(disc, 0.02, 0.001, 100).depth - exact,
                 fine = solve(disc, 0.02, 0.001, 200).depth - exact;
    EXPECT_NEAR(coarse / fine, 4, 0.4);
  }
}

TEST(Foeppl, ForceInvertsDepth) {
  for (const double pretension : {0.0, 1e-3, 0.1}) {
    const FoepplDisc disc{0.165, 0.033, 1e-6};
    EXPECT_NEAR(force_at(disc, depth_under(disc, 0.01, pretension), pretension) / 0.01, 1, 1e-8);
  }
}

class Table : public testing::TestWithParam<double> {};

TEST_P(Table, HoldsWhatTheEquationsGive) {
  const double tip = GetParam(), nu = 0.165;
  const FoepplCurve curve(nu, tip);
  for (const double eta : {0.0, 1e-3, 0.02, 0.3, 1.7, 25.0, 700.0}) {
    const double depth = 0.05, direct = force_at({nu, tip, 0}, depth, eta * depth * depth) / std::pow(depth, 3);
    EXPECT_NEAR(curve.g(eta) / direct, 1, 1e-5) << eta;
    if (eta == 0) continue;
    const double h = 1e-4 * eta;
    EXPECT_NEAR(curve.slope(eta) / ((curve.g(eta + h) - curve.g(eta - h)) / (2 * h)), 1, 1e-5) << eta;
  }
}

INSTANTIATE_TEST_SUITE_P(Tips, Table, testing::Values(0.0, 0.0033, 0.1));

}  // namespace
