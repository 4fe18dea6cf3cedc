// A flat annulus between a rigid hub (radius a) and a rigid rim (radius b), the hub turned by a small angle
// theta: tension field, no prestress, small strain, E·h and nu.
//
// Lines of tension are straight (the balance along and across them) and touch a circle of radius c < a, so
// that r sin β = c with β from the radius; each bears E·h times its strain. The torque is
//   T = 4π E·h theta c² / ln[(b² − c²)/(a² − c²)],
// c making it largest, which is the same as no radial displacement at both edges. The whole annulus is
// wrinkled as long as nu ≤ c²/(b² − c²), the state being nearest to taut at the rim. Reissner, Proc. 5th Int.
// Congr. Appl. Mech. (1938) 88; Mansfield, Proc. R. Soc. A 316 (1970) 269. Two ways: the formula, and the
// boundary value problem without any of the above but the wrinkled law. They agree to ten digits
// (annulus_torsion_test).
#pragma once

namespace reference {

struct AnnulusTorsion {
  double torque;      ///< T / (E·h theta a²)
  double tangent;     ///< c/a
  double largest_nu;  ///< up to which the annulus is wrinkled all over
};

/// The formula; b/a > 1.
AnnulusTorsion annulus_torsion(double rim_over_hub);

/// Shooting in r: N = N1 m⊗m, (r N_rr)' = N_θθ, r² N_rθ = T/2π, N1 = E·h E1, u(a) = u(b) = 0.
AnnulusTorsion annulus_torsion_by_shooting(double rim_over_hub, int steps = 64);

}  // namespace reference
