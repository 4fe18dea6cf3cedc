// Discs under pressure: Hencky's series, finite strain with a following pressure, the Mylar balloon.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "reference/convergence.hpp"
#include "reference/foppl_disc.hpp"
#include "reference/hencky.hpp"
#include "reference/mylar_balloon.hpp"
#include "reference/svk_pressure.hpp"

namespace reference {
namespace {

// C(0.3) = 0.653 (Hencky 1915; Fichter 1997), six digits as computed elsewhere.
TEST(Hencky, HasTheKnownHeights) {
  EXPECT_NEAR(hencky(0.3).height, 0.653443, 5e-7);
  EXPECT_NEAR(hencky(0.19).height, 0.679687, 5e-7);
}

// Fichter, NASA TP-3658 (1997), table 1, b_0 = N_r(0) with E·h P² /4 for
// unit: 1.6204, 1.6827, 1.7244, 1.7769.
TEST(Hencky, HasFichtersCentralForce) {
  EXPECT_NEAR(4 * hencky(0).centre_force, 1.6204, 1e-4);
  EXPECT_NEAR(4 * hencky(0.2).centre_force, 1.6827, 1e-4);
  EXPECT_NEAR(4 * hencky(0.3).centre_force, 1.7244, 1e-4);
  EXPECT_NEAR(4 * hencky(0.4).centre_force, 1.7769, 1e-4);
}

TEST(Hencky, IsTheDiscLoadedToItsRim) {
  for (const double nu : {0.0, 0.19, 0.3})
    EXPECT_NEAR(foppl_disc({nu, 1}, std::numbers::pi, 200).centre, hencky(nu).height, 1e-11) << nu;
}

TEST(Hencky, Converges) {
  for (const double nu : {0.0, 0.3, 0.5}) EXPECT_NEAR(hencky(nu).height, hencky(nu, 120).height, 1e-12) << nu;
}

TEST(SvkPressure, IsHenckysAtSmallPressure) {
  for (const double nu : {0.19, 0.3}) {
    const auto excess = [nu](double P) {
      return svk_pressure({1, nu}, 1, P * P * P, Rim::clamped).height / (hencky(nu).height * P) - 1;
    };
    EXPECT_LT(std::abs(excess(0.02)), 2e-4);
    EXPECT_NEAR(excess(0.04) / excess(0.02), 4, 0.1);  // of second order in P
  }
}

TEST(SvkPressure, DoesAsMuchWorkAsItStores) {
  for (const Rim rim : {Rim::clamped, Rim::sliding}) {
    const SvkSheet sheet{1, 0.19, 0.01, rim == Rim::sliding};
    const int steps = sheet.wrinkles ? 1024 : 128;
    const auto remainder = [&](double step) {
      const auto less = svk_pressure(sheet, 1, 0.1 - step, rim, steps);
      const auto more = svk_pressure(sheet, 1, 0.1 + step, rim, steps);
      return (more.energy - less.energy) / (more.volume - less.volume) / 0.1 - 1;
    };
    EXPECT_LT(std::abs(remainder(0.01)), 2e-3);
    EXPECT_NEAR(remainder(0.02) / remainder(0.01), 4, 0.2);
  }
}

TEST(SvkPressure, Converges) {
  const auto height = [](int steps) { return svk_pressure({1, 0.19}, 1, 0.1, Rim::clamped, steps).height; };
  testing::expect_converges(height, 16, 6, 1e-12);
  testing::expect_settled(height, 128, 1e-9);
  const auto wrinkled = [](int steps) { return svk_pressure({1, 0.3, 0, true}, 1, 1e-3, Rim::sliding, steps).height; };
  testing::expect_settled(wrinkled, 256, 5e-6);
}

// Paulsen 1994.
TEST(MylarBalloon, HasPaulsensNumbers) {
  EXPECT_NEAR(mylar_balloon().height, 0.456947, 5e-7);
  EXPECT_NEAR(mylar_balloon().radius, 0.762760, 5e-7);
}

// Two elastic discs that wrinkle, the less pressure, the less they stretch: near the axis a taut spot
// remains.
TEST(MylarBalloon, IsTheLimitOfTensionFieldDiscs) {
  const MylarBalloon limit = mylar_balloon();
  double last_height = 1, last_radius = 1;
  for (const double pressure : {1e-2, 1e-3, 1e-4, 1e-5}) {
    const SvkPressureState state = svk_pressure({1, 0.3, 0, true}, 1, pressure, Rim::sliding, 512);
    const double height = state.height - limit.height, radius = state.rim_radius - limit.radius;
    EXPECT_GT(height, 0);
    EXPECT_LT(height, last_height / 3.5);
    EXPECT_LT(radius, last_radius / 3.5);
    last_height = height;
    last_radius = radius;
  }
  EXPECT_LT(last_height, 2e-4);
  EXPECT_LT(std::abs(last_radius), 1e-5);
}

}  // namespace
}  // namespace reference
