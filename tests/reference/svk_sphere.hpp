// Rigid frictionless sphere of radius Rt pressed into a clamped, pretensioned disc, at finite strain.
//
// Where sheet and sphere touch, R ≤ b, the sheet has the sphere's shape, r = Rt sin φ, hence dφ/dR = λ1/Rt,
// and without friction the balance along the meridian is (R T1)' = T2 cos φ. Outside, V = F/2π stays and
// H' = T2 (svk_sheet.hpp). The slope is continuous at R = b. In x = ln R with y = φ/R and T1:
//   dy/dx = λ1/Rt − y,  dT1/dx = T2 cos φ − T1.
// b is given, the membrane force at the axis shot for, F follows. The limit of a weak push on a tight sheet
// is in shallow_tip.hpp. Equilibrium: Green & Adkins, Large Elastic Deformations, ch. 4.
//
// Accuracy: nine digits (the step halved; F = dU/ddelta: svk_sphere_test).
#pragma once

#include "reference/svk_sheet.hpp"

namespace reference {

struct SvkSphere {
  SvkSheet sheet;
  double radius;      ///< a
  double tip_radius;  ///< Rt
};

struct SvkSphereState {
  double contact_radius;  ///< b, material
  double force;           ///< F
  double depth;           ///< −z(0), the sphere's lowest point
  double rim_force;       ///< S_R·h at the rim
  double energy;          ///< of the whole sheet, 0 at rest
  double least_pressure;  ///< smallest contact pressure found, per deformed area; > 0 where the sheet lies on
};

/// State with the contact radius b, 0 < b < a, reached before the sheet is vertical there.
SvkSphereState svk_sphere_at_contact(const SvkSphere& sphere, double contact_radius, int steps = 48);

/// State at the depth > 0.
SvkSphereState svk_sphere_at_depth(const SvkSphere& sphere, double depth, int steps = 48);

}  // namespace reference
