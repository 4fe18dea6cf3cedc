// Uniform load on a disc of radius c on a clamped, pretensioned Föppl–von Kármán membrane of radius a = 1 and
// sheet modulus E·h = 1.
//
// Equilibrium (r N_r)' = N_θ, slope −w' = v/N_r with 2π r v = F min(1, r²/c²) the enclosed load, and the
// strains' compatibility; in x = ln r:  dN_r/dx = N_θ − N_r,  dN_θ/dx = N_r − N_θ − w'²/2,  N_r = N_θ at the
// axis, and N_θ − nu N_r = (1 − nu) N0 at the rim. The force at the centre is shot for. c = 1 is Hencky's
// problem of uniform pressure F/π; c → 0 the point load. Föppl (1907), von Kármán (1910).
// Accuracy: ten digits, some six at c/a = 1e-6 (the step halved, foppl_test).
#pragma once

namespace reference {

struct FopplDisc {
  double nu;
  double load_radius;     ///< c/a, in (0, 1]
  double pretension = 0;  ///< N0 / E·h, ≥ 0
};

struct FopplDepth {
  double centre;     ///< −w(0) / a
  double conjugate;  ///< mean of −w over the loaded disc, / a
  double rim_force;  ///< N_r(a) / E·h
};

/// Depth under the total force F / (E·h a) > 0. `steps` for each of the inner and the outer part.
FopplDepth foppl_disc(const FopplDisc& disc, double force, int steps = 100);

}  // namespace reference
