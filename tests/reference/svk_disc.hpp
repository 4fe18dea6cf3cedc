// Clamped disc under a dead load, uniform per material area on a central disc, at finite strain and slope:
// V = F/2π min(1, R²/c²), H' = T2 (see svk_sheet.hpp), r = R at the rim. The membrane force at the centre is
// shot for, in x = ln R. c → 0 is the point load: at given depth the force exceeds its limit by some
// 1.7 (c/a)^(2/3) of itself.
//
// Gil, Adhikari, Scarpa, Bonet, J. Phys.: Condens. Matter 22 (2010) 145302, state the law; equilibrium of
// axisymmetric membranes: Green & Adkins, Large Elastic Deformations, ch. 4.
// Accuracy: nine digits for c/a ≥ 1e-3, some six at 1e-6 (the step halved, svk_disc_test).
#pragma once

#include "reference/svk_sheet.hpp"

namespace reference {

struct SvkDisc {
  SvkSheet sheet;
  double radius;       ///< a
  double load_radius;  ///< c, in (0, a]
};

struct SvkDiscState {
  double force;            ///< F
  double centre_depth;     ///< −z(0)
  double conjugate_depth;  ///< mean of −z over the loaded material disc
  double rim_force;        ///< S_R·h at the rim
  double energy;           ///< of the whole sheet, 0 at rest
};

/// State under the force F > 0. `steps` for each of the inner and the outer part.
SvkDiscState svk_disc_at_force(const SvkDisc& disc, double force, int steps = 48);

/// State at the centre depth > 0.
SvkDiscState svk_disc_at_depth(const SvkDisc& disc, double centre_depth, int steps = 48);

}  // namespace reference
