// Point load on a clamped Föppl–von Kármán membrane: moderate slopes, small strain, linear elastic.
//
// With psi = r N_r, x = ln r and V = F / 2π:  psi'' − psi = −(E·h/2) r V²/psi²,  w' = −V/psi,  and at the rim
// r = a (no radial displacement) psi' = nu psi. psi = r^(1/3) g makes this autonomous,
//   g'' + (2/3) g' − (8/9) (g − g0³/g²) = 0,   g0³ = 9 E·h V² / 16,
// so that every Poisson ratio is a point of one curve: the way out of the saddle g = g0 along r^(4/3). At
// nu = 1/3 it has not left yet (Schwerin, Z. Tech. Phys. 12 (1929) 651). Föppl (1907), von Kármán (1910).
//
// A small isotropic pretension N0 adds N0 ∫ tr E dA to the energy at given depth, to first order, with E the
// strain without it; tr E = (1 − nu)(N_r + N_θ)/E·h and r (N_r + N_θ) = (r psi)' bring it to the rim:
//   F = alpha E·h delta³/a² + beta π N0 delta,  beta = 4 (1 − nu) N_r(a) a² / (E·h delta²).
// Accuracy: ten digits (the step halved, foppl_test).
#pragma once

namespace reference {

struct PointLoad {
  double alpha;      ///< F a² / (E·h delta³) without pretension
  double beta;       ///< (F − F without pretension) / (π N0 delta), N0 → 0
  double rim_force;  ///< N_r(a) a² / (E·h delta²) without pretension
};

/// −1 < nu < 1.
PointLoad foppl_point(double nu, int steps = 400);

}  // namespace reference
