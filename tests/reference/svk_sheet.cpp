#include "reference/svk_sheet.hpp"

#include <algorithm>
#include <cmath>

namespace reference {

namespace {

// The positive root of A λ³ + B λ = T, A, T > 0: Newton from above, monotone since the cubic is convex there.
double tension_root(double A, double B, double T) {
  double stretch = std::cbrt(T / A) + std::sqrt(std::max(0.0, -B / A));
  for (int i = 0; i < 100; ++i) {
    const double step = (A * stretch * stretch * stretch + B * stretch - T) / (3 * A * stretch * stretch + B);
    stretch -= step;
    if (std::abs(step) < 1e-9 * stretch) break;  // the next step would be 1e-18
  }
  return stretch;
}

double strain(double stretch) { return (stretch * stretch - 1) / 2; }

}  // namespace

SvkPoint svk_point(const SvkSheet& sheet, double tension, double hoop_stretch) {
  const double nu = sheet.nu, N0 = sheet.pretension, hoop_strain = strain(hoop_stretch);
  const double c = sheet.modulus / (1 - nu * nu);
  const double rest_energy = N0 * N0 * (1 - nu) / sheet.modulus;  // of the offset strain

  // Taut: T1 = λ1 (c (E1 + nu E2) + N0).
  SvkPoint at{};
  at.stretch = tension_root(c / 2, c * (nu * hoop_strain - 0.5) + N0, tension);
  const double E1 = strain(at.stretch), E2 = hoop_strain;
  const double S2 = c * (E2 + nu * E1) + N0;
  at.hoop_force = hoop_stretch * S2;
  at.energy = c / 2 * (E1 * E1 + E2 * E2 + 2 * nu * E1 * E2) + N0 * (E1 + E2);
  if (S2 >= 0 || !sheet.wrinkles) return at;

  // Wrinkled along the meridian: T1 = λ1 (E·h E1 + (1 − nu) N0), no hoop force, width free.
  at.stretch = tension_root(sheet.modulus / 2, (1 - nu) * N0 - sheet.modulus / 2, tension);
  const double S1 = sheet.modulus * strain(at.stretch) + (1 - nu) * N0;
  at.hoop_force = 0;
  at.energy = S1 * S1 / (2 * sheet.modulus) - rest_energy;
  return at;
}

double svk_equibiaxial_stretch(const SvkSheet& sheet, double force) {
  return std::sqrt(1 + 2 * (force - sheet.pretension) * (1 - sheet.nu) / sheet.modulus);
}

}  // namespace reference
