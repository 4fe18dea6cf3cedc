// A tip that barely dents a tight sheet: tension N0 everywhere, clamped at r = a, small slope: Laplace's
// equation N0 Δw = load. Closed forms, the limits of every indentation curve at pretension ≫ stretching.
//
// Disc of radius c, uniform load F: outside N0 w' r = F/2π, inside w falls by F/(4π N0) more:
//   F/delta = 2π N0/(ln(a/c) + ½) at the centre,  … + ¼ for the mean depth of the disc.
// Frictionless sphere of radius Rt touching up to b: F = 2π N0 b²/Rt, delta = (b²/Rt)(ln(a/b) + ½).
// Vella & Davidovitch, Soft Matter 13 (2017) 2264.
#pragma once

#include <cmath>
#include <numbers>

namespace reference {

/// F/(N0 delta) with delta the depth of the centre; c/a in (0, 1].
inline double shallow_disc_stiffness(double load_radius_over_a) {
  return 2 * std::numbers::pi / (0.5 - std::log(load_radius_over_a));
}

/// F/(N0 d) with d the mean depth of the loaded disc, conjugate to F.
inline double shallow_disc_conjugate_stiffness(double load_radius_over_a) {
  return 2 * std::numbers::pi / (0.25 - std::log(load_radius_over_a));
}

struct ShallowSphere {
  double force;  ///< F/(N0 a)
  double depth;  ///< delta/a
};

/// At the contact radius b/a, for a sphere of radius Rt/a.
inline ShallowSphere shallow_sphere(double tip_radius_over_a, double contact_radius_over_a) {
  const double b2 = contact_radius_over_a * contact_radius_over_a / tip_radius_over_a;
  return {2 * std::numbers::pi * b2, b2 * (0.5 - std::log(contact_radius_over_a))};
}

}  // namespace reference
