// The material point of an axisymmetric sheet at finite strain: plane-stress St Venant–Kirchhoff with
// isotropic prestress, S = C:E + N0 I, taut or in tension field.
//
// Kinematics and balance of all axisymmetric solvers here (material radius R, deformed radius r, slope angle
// φ below the horizontal, stretches λ1 along the meridian and λ2 = r/R along the hoop, nominal membrane
// forces T_i = λ_i S_i per undeformed length):
//   r' = λ1 cos φ,  z' = −λ1 sin φ,  H = R T1 cos φ,  V = R T1 sin φ,  H' = T2 (+ load),  V' = load.
// Given (r, H) and the enclosed load V, the meridional tension T1 = √(H² + V²)/R fixes λ1, so that two
// equations of first order remain. In x = ln R, with q = λ2 − 1 and t = H/R (constant near the axis):
//   dq/dx = λ1 cos φ − λ2,  dt/dx = T2 − t (+ load).
// Any consistent units; forces per length are times the thickness.
#pragma once

namespace reference {

struct SvkSheet {
  double modulus;         ///< E·h > 0
  double nu;              ///< in (−1, 1)
  double pretension = 0;  ///< N0 = σ0·h ≥ 0
  bool wrinkles = false;  ///< tension field: no hoop compression (the meridian is always in tension here)
};

struct SvkPoint {
  double stretch;     ///< λ1
  double hoop_force;  ///< T2
  double energy;      ///< per material area, 0 at rest
};

/// The point under the meridional tension T1 > 0 at hoop stretch λ2 > 0.
SvkPoint svk_point(const SvkSheet& sheet, double tension, double hoop_stretch);

/// The equibiaxial stretch at which S1 = S2 = force > 0: the state at the axis.
double svk_equibiaxial_stretch(const SvkSheet& sheet, double force);

}  // namespace reference
