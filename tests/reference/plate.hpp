// Clamped von Kármán plate, stretched, under a uniform load on a central disc: a sheet with bending.
//
// Units of a = E·h = 1, D = κ/(E·h a²). With the slope β = −w' (w up) and m = β' + β/r, in x = ln r:
//   dβ/dx = r m − β,               D dm/dx = r N_r β − F/2π min(1, r²/c²),
//   dN_r/dx = N_θ − N_r,           dN_θ/dx = N_r − N_θ − β²/2,
// regular at the axis (β = r m/2, N_r = N_θ); at the rim β = 0 and N_θ − nu N_r = (1 − nu) N0.
// Timoshenko & Woinowsky-Krieger, Theory of Plates and Shells, 2nd ed., ch. 13.
//
// Solved on a mesh graded towards the disc's edge and the rim (bending layers √(D/N_r)) by Hermite–Simpson
// collocation, order 4, and Newton's method along growing forces.
// Limits: linear F = 16π D delta, membrane F = alpha delta³ (foppl_disc.hpp), and small depths under
// pretension, where w is made of ln r and Bessel functions (tight_plate_stiffness).
// Accuracy: nine digits for D ≥ 1e-6, seven at 1e-8 (the steps halved, plate_test).
#pragma once

namespace reference {

struct Plate {
  double nu;
  double load_radius;     ///< c/a, in (0, 1]
  double bending;         ///< D = κ/(E·h a²) > 0
  double pretension = 0;  ///< N0/(E·h) ≥ 0
};

struct PlateState {
  double centre_depth;     ///< −w(0)/a
  double conjugate_depth;  ///< mean of −w over the loaded disc, / a
  double rim_force;        ///< N_r(a)/(E·h)
  double energy;           ///< / (E·h a²): bending ½ D m² (clamped: no Gaussian part) and stretching, 0 at rest
};

/// State under F/(E·h a) > 0. `steps` for each of the inner and the outer part. Throws std::runtime_error
/// when Newton's method fails.
PlateState plate(const Plate& plate, double force, int steps = 400);

/// F/(E·h delta) of a point load on a tight plate, delta → 0, in closed form; `pretension` > 0.
double tight_plate_stiffness(double bending, double pretension);

}  // namespace reference
