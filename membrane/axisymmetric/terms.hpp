// The terms of the sheet's energy, each as a density per reference area at one point of the meridian, with
// its first and second derivatives by the local state. A further term is a struct here and a name in
// EnergyTerm.
#pragma once

#include <variant>

#include "membrane/axisymmetric/hermite.hpp"
#include "membrane/laws/list.hpp"

namespace membrane::axisymmetric {

/// What a quadrature point stands for.
struct Ring {
  double radius_A = 0;  ///< in the reference, > 0
  double area_A2 = 0;
};

struct Density {
  double value = 0;  ///< eV/Å²
  LocalState gradient = LocalState::Zero();
  Eigen::Matrix<double, 6, 6> hessian = Eigen::Matrix<double, 6, 6>::Zero();  ///< symmetric
};

/// psi(Ē) − psi(E0) with E_r = u' + ½ (u'² + w'²), E_hoop = u/s + ½ (u/s)², s the reference radius.
struct Stretching {
  Law law;
  double offset = 0;  ///< principal value of the prestress's offset strain E0
  bool relaxed = true;
  double flat_energy = 0;  ///< psi(E0), eV/Å²

  Density operator()(const Ring& ring, const LocalState& y) const;
  /// [E_r, E_hoop, 0], the sheet's own.
  static Voigt strain(double s, const LocalState& y);
  /// The law at a strain of the sheet.
  Response response(const Voigt& strain) const;
};

/// ½ κ (κ1 + κ2)² with the principal curvatures of the deformed surface, exact at any rotation:
/// κ1 = [(1 + u') w'' − w' u'']/λ³ along the meridian and κ2 = w'/(λ (s + u)) around, λ² = (1 + u')² + w'².
struct Bending {
  double modulus_eV = 0;

  Density operator()(const Ring& ring, const LocalState& y) const;
};

/// −p V with V = −∫ π (s + u)² w' ds, the volume between the surface and its rim's plane: a follower pressure
/// whose tangent is symmetric, since the rim stays in that plane.
struct Pressure {
  double pressure_eV_per_A3 = 0;

  Density operator()(const Ring& ring, const LocalState& y) const;
};

/// A rigid frictionless sphere: ½ k g² per ring where the gap g = |x − centre| − radius is negative. The
/// stiffness is a ring's: however small the spot that bears the load, it enters the sphere by no more than force/k. To
/// find the contact there is a foundation's, per area: however wide the sphere is entered, no ring is pulled like a point,
/// which a law that softens could not bear.
struct SphereContact {
  double radius_A = 0;
  double depth_A = 0;               ///< of its lowest point
  double stiffness_eV_per_A2 = 0;   ///< k
  double foundation_eV_per_A4 = 0;  ///< the same per reference area

  Density operator()(const Ring& ring, const LocalState& y) const;
  /// Negative inside the sphere, Å.
  double gap(const Ring& ring, const LocalState& y) const;
  /// Vertical force on a ring, eV/Å.
  double force(const Ring& ring, const LocalState& y) const;
  /// Of a ring, eV/Å².
  double stiffness(const Ring& ring) const { return stiffness_eV_per_A2 + foundation_eV_per_A4 * ring.area_A2; }
};

/// The terms that are spread over the whole sheet.
using EnergyTerm = std::variant<Stretching, Bending, Pressure>;

}  // namespace membrane::axisymmetric
