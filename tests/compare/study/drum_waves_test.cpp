#include "compare/study/drum_waves.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace validate;

namespace {

constexpr double radius_A = 30, kappa_eV = 1.9, modulus_eV_per_A2 = 22, nu = 0.1;

Drum drum_of(const membrane::CauchyBorn& law) {
  return {.a_A = radius_A,
          .slope_margin_A = 0,
          .bending_modulus_eV = kappa_eV,
          .law = &law,
          .area_per_atom_A2 = 2.7,
          .mass_u = 12.011,
          .shortest_wave_A = 16};
}

/// Flat under an equibiaxial strain.
std::vector<membrane::MeridianPoint> stretched(double strain) {
  std::vector<membrane::MeridianPoint> points;
  const double force = modulus_eV_per_A2 / (1 - nu) * strain;
  for (int i = 0; i <= 30; ++i) {
    const double r = radius_A * i / 30;
    points.push_back({r, r * (std::sqrt(1 + 2 * strain) - 1), 0, strain, strain, force, force});
  }
  return points;
}

/// The clamped plate's k²a²: 10.2158, 21.2604, 34.8770 (Leissa, Vibration of Plates, 1969).
TEST(DrumWaves, OfAFlatSheetAreThoseOfAClampedPlate) {
  const membrane::CauchyBorn law{modulus_eV_per_A2, nu, {}};
  const double frequencies[] = {10.2158, 21.2604, 34.8770};
  for (int m = 0; m < 3; ++m)
    EXPECT_NEAR(std::pow(flat_wave_numbers(drum_of(law), m)[0] * radius_A, 2), frequencies[m], 2e-4 * frequencies[m]);
}

/// Under a tension that leaves bending little to say: the membrane's 2.40483 and 3.83171, on a radius that the boundary
/// layer √(κ/τ) shortens.
TEST(DrumWaves, OfAStretchedSheetAreThoseOfAMembrane) {
  const membrane::CauchyBorn law{modulus_eV_per_A2, nu, {}};
  constexpr double strain = 0.2;
  const double tension = modulus_eV_per_A2 / (1 - nu) * strain, zeros[] = {2.40483, 3.83171};
  const double shorter = radius_A - std::sqrt(kappa_eV / tension);
  for (int m = 0; m < 2; ++m) {
    const double expected = 2.7 * tension * std::pow(zeros[m] / shorter, 2);
    EXPECT_NEAR(flexural_eigenvalues(drum_of(law), stretched(strain), m)[0], expected, 0.03 * expected) << m;
  }
}

/// Tension makes every wave stiffer; a compressed sheet has no free energy.
TEST(DrumWaves, TheFreeEnergyGrowsWithTension) {
  const membrane::CauchyBorn law{modulus_eV_per_A2, nu, {}};
  const DrumWaves waves(drum_of(law), {.temperature_K = 300});
  EXPECT_GT(waves(stretched(0.01)), waves(stretched(0)));
  EXPECT_NEAR(waves(stretched(0)), waves({}), 1e-9);
  EXPECT_TRUE(std::isnan(waves(stretched(-0.01))));
}

}  // namespace
