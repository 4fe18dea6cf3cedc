#include "compare/fitting/models/eq16.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "compare/base/units.hpp"

using validate::Eq16;

// Depths at which Eq. 16 reaches a force, from bisection: inverse of a monotone function.
static double depth_at(const Eq16& model, double force, double Eh, double pretension) {
  double low = 0, high = model.a_A;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    (model.force(middle, Eh, pretension) < force ? low : high) = middle;
  }
  return low;
}

TEST(Eq16, ReachesTheDepthsOfThePapersCases) {
  // Origin: design document physics.md section 3, "Case 2" and "Case 1", computed apart from this code; the
  // tolerance is half of the last digit given there.
  const Eq16 case_2{110, 0.19};
  EXPECT_NEAR(depth_at(case_2, 20, 5.864 * 1.37, 0), 31.604, 5e-4);

  const Eq16 case_1{5000, 0.165};
  const double force = 1500 / validate::nN_per_eV_per_A;
  const double Eh = 342 / validate::N_per_m_per_eV_per_A2, pretension = 0.34 / validate::N_per_m_per_eV_per_A2;
  EXPECT_NEAR(depth_at(case_1, force, Eh, pretension), 1026.4, 5e-2);
}

TEST(Eq16, NearTheExactPointLoadAtOneThird) {
  // Schwerin's exact coefficient pi/3 at nu = 1/3; q³ stays within 1 % of it.
  const Eq16 model{1, 1.0 / 3};
  EXPECT_NEAR(std::pow(model.q(), 3) / (std::numbers::pi / 3), 1, 0.01);
}

TEST(Eq16, GradientIsTheValuesDerivative) {
  const Eq16 model{110, 0.3645};
  const double at[] = {17.3, 0.02};
  double gradient[2];
  model.gradient(12, at, gradient);
  for (int i = 0; i < 2; ++i) {
    double up[] = {at[0], at[1]}, down[] = {at[0], at[1]};
    up[i] *= 1.01;
    down[i] *= 0.99;
    const double difference = (model.value(12, up) - model.value(12, down)) / (up[i] - down[i]);
    EXPECT_NEAR(gradient[i] / difference, 1, 1e-10);  // linear: no truncation error, rounding only
  }
}
