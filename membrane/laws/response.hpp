// What a material law is asked and what it answers.
#pragma once

#include <Eigen/Core>
#include <concepts>

namespace membrane {

/// Green–Lagrange strain as [E11, E22, 2 E12], or second Piola–Kirchhoff membrane force as [S11, S22, S12]:
/// their dot product is the work S:E.
using Voigt = Eigen::Vector3d;

/// A law at one strain, all in membrane forces (thickness folded in).
struct Response {
  double energy_eV_per_A2 = 0;                                  ///< psi, per reference area
  Voigt force_eV_per_A2 = Voigt::Zero();                        ///< S = d psi / dE
  Eigen::Matrix3d tangent_eV_per_A2 = Eigen::Matrix3d::Zero();  ///< dS / d[E11, E22, 2 E12], symmetric
};

/// A law under tension along one axis only, the width free: what is left of it when wrinkled.
struct UniaxialResponse {
  double energy_eV_per_A2 = 0;   ///< psi at the natural width
  double force_eV_per_A2 = 0;    ///< S1, the only membrane force
  double tangent_eV_per_A2 = 0;  ///< dS1 / dE1 along the natural width
};

/// A law: public parameters, its small-strain constants, and one call E -> (psi, S, dS/dE). Prestress is no business of
/// a law: it enters as an offset strain.
template <class L>
concept MaterialLaw = requires(const L& law, const Voigt& strain, double axial_strain) {
  { law.sheet_modulus_eV_per_A2 } -> std::convertible_to<double>;  ///< E·h
  { law.nu } -> std::convertible_to<double>;
  { law(strain) } -> std::same_as<Response>;
  /// Strain across an axis (a lattice's zigzag) at which the force across vanishes: the natural width. NaN: none.
  { law.natural_width(axial_strain) } -> std::same_as<double>;
  /// lambda3, thickness over reference thickness, in plane stress at this strain (that of the sheet, not
  /// offset by a prestress). A law that has no 3-D parent has no thickness to change: 1. NaN beyond the
  /// parent's range.
  { law.thickness_stretch(strain) } -> std::same_as<double>;
  /// Throws std::invalid_argument when the parameters make no sense.
  { law.check() } -> std::same_as<void>;
};

/// The same from every direction, so that strain and force have common axes: it answers with the width free, too.
template <class L>
concept IsotropicLaw = MaterialLaw<L> && requires(const L& law, double axial_strain) {
  { law.uniaxial(axial_strain) } -> std::same_as<UniaxialResponse>;
};

/// A law with directions of its own: what wrinkles do to it is solved for (directional_wrinkling.hpp).
template <class L>
concept DirectionalLaw = MaterialLaw<L> && !IsotropicLaw<L>;

}  // namespace membrane
