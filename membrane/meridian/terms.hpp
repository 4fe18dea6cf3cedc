// The terms of the sheet's energy, each as a density per reference area at one point of the meridian, with
// its first and second derivatives by the local state. A further term is a struct here and a name in
// EnergyTerm.
#pragma once

#include <variant>

#include "membrane/laws/list.hpp"
#include "membrane/laws/sheet_state.hpp"
#include "membrane/meridian/hermite.hpp"

namespace membrane::meridian {

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
  /// What a relaxed sheet does at a strain of the sheet.
  SheetState state(const Voigt& strain) const;
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

/// A rigid frictionless tip: a sphere, and above its centre a cylinder of the same radius, so that no step can take a
/// sheet to its other side. What keeps the sheet out is a barrier −µ ln(gap/radius), that is a pressure µ/gap: the
/// smaller µ, the closer both come to contact, where one of the two is zero.
struct SphereContact {
  double radius_A = 0;
  double depth_A = 0;            ///< of its lowest point
  double barrier_eV_per_A2 = 0;  ///< µ

  /// Positive outside, Å.
  double gap(const Ring& ring, const LocalState& y) const;
  /// Of the gap by y.
  LocalState normal(const Ring& ring, const LocalState& y) const;
  /// The barrier; infinite inside.
  Density operator()(const Ring& ring, const LocalState& y) const;
  /// The same, but the Hessian that of a sheet that bears this pressure (eV/Å³) across its gap.
  Density operator()(const Ring& ring, const LocalState& y, double pressure_eV_per_A3) const;
};

/// The terms that are spread over the whole sheet.
using EnergyTerm = std::variant<Stretching, Bending, Pressure>;

}  // namespace membrane::meridian
