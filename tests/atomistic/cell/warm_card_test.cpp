#include "atomistic/cell/warm_card.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/atomistic/support/paths.hpp"

namespace {

using namespace atomistic;

WarmCard warm(double temperature, Statistics statistics) {
  return compute_warm_card(potential("tersoff"), card_of("tersoff"),
                           {.temperature_K = temperature, .statistics = statistics}, "none");
}

/// Zero-point motion stretches the lattice by some 0.34 %, and the longer waves of a hotter sheet shorten it again.
TEST(WarmCard, ZeroPointMotionStretchesTheLattice) {
  const double a0 = card_of("tersoff").a0_A;
  const double cold = warm(10, Statistics::quantum).lattice_constant_A / a0 - 1;
  const double room = warm(300, Statistics::quantum).lattice_constant_A / a0 - 1;
  EXPECT_NEAR(room, 0.0034, 0.0003);
  EXPECT_GT(cold, room);
}

/// Classical vibrations do nothing at T = 0 and go with T.
TEST(WarmCard, ClassicalVibrationsGoWithTheTemperature) {
  const Card& card = card_of("tersoff");
  const WarmCard cold = warm(1, Statistics::classical), room = warm(300, Statistics::classical);
  EXPECT_NEAR(cold.lattice_constant_A, card.a0_A, 1e-5 * card.a0_A);
  EXPECT_NEAR(cold.C11_eV_per_A2, card.C11_eV_per_A2, 5e-4 * card.C11_eV_per_A2);
  EXPECT_NEAR((room.lattice_constant_A - card.a0_A) / (cold.lattice_constant_A - card.a0_A), 300, 40);
  EXPECT_LT(room.C11_eV_per_A2, card.C11_eV_per_A2);
}

}  // namespace
