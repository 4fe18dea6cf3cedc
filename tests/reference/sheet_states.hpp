// Homogeneous states of the relaxed plane-stress St Venant–Kirchhoff sheet in closed form. E·h = 1; N0 is the
// isotropic pretension σ0·h/(E·h), which shifts every strain by E0 = (1 − nu) N0.
// Gil, Adhikari, Scarpa, Bonet, J. Phys.: Condens. Matter 22 (2010) 145302, Eqs. 7, 12, 15.
#pragma once

#include <cmath>

namespace reference {

/// S1/(E·h) in simple shear F = [1 γ; 0 1] without prestress: the larger principal value of E = ½[0 γ; γ γ²],
/// wrinkled as long as E2 + nu E1 ≤ 0 (nu ≤ 0.9 at γ = 0.1).
inline double simple_shear_wrinkled_force(double shear) {
  return (shear * shear / 2 + std::abs(shear) * std::sqrt(1 + shear * shear / 4)) / 2;
}

/// Stretch across the axis at which the force across vanishes, at the stretch along it: Ē2 = −nu Ē1.
inline double natural_width(double nu, double stretch, double pretension = 0) {
  const double E0 = (1 - nu) * pretension, E1 = (stretch * stretch - 1) / 2;
  return std::sqrt(1 + 2 * (-nu * (E1 + E0) - E0));
}

/// The larger principal stretch at and below which the sheet is slack: Ē1 = 0.
inline double slack_stretch(double nu, double pretension) { return std::sqrt(1 - 2 * (1 - nu) * pretension); }

}  // namespace reference
