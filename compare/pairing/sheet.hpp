// The sheet that the atoms of a case form, and the continuum's lengths that belong to it.
#pragma once

#include <Eigen/Core>

#include "atomistic/lattice/sheet.hpp"
#include "atomistic/problem.hpp"
#include "compare/input/case.hpp"

namespace validate {

/// Standard errors of a sheet's clamp radius and of its slope margin, in bonds. The first is what the deep end of 140
/// discs (five potentials, R = 18 to 45 Å) leaves when it is read as a radius, rms: 0.066, the means of single
/// potentials (−0.09 for AIREBO to +0.03) included. The second is the scatter of margins over sizes about the card's
/// mean.
inline constexpr double clamp_margin_error_bonds = 0.07, slope_margin_error_bonds = 0.05;
/// Of the radius of a loaded disc that stands for atoms of the same area: 0.1 % in force for a disc of 10 Å on 110 Å,
/// which is what was found there (0.5 to 0.8 % for 5 Å, nothing for tips of nanometres).
inline constexpr double tip_radius_error_bonds = 0.026;

class PairedSheet {
 public:
  /// Throws Error (bad input) for a sheet too small for a lattice.
  PairedSheet(const Case& c, const atomistic::Potential& potential, const atomistic::Card& card);

  const atomistic::Sheet& sheet() const { return sheet_; }

  /// Half lengths of the continuum along x and y (of a disc: its radius twice). Clamped: those of the free atoms' area
  /// and the card's margin; sliding: where the outermost atoms are, which the supports hold at z = 0.
  const Eigen::Vector2d& half_A() const { return half_A_; }
  double effective_radius_A() const { return half_A_.x(); }
  /// Standard error of that radius.
  double clamp_radius_error_A() const { return clamp_margin_error_bonds * sheet_.bond_A; }
  double tip_radius_error_A() const { return tip_radius_error_bonds * sheet_.bond_A; }
  double slope_margin_error_A() const { return slope_margin_error_bonds * sheet_.bond_A; }

  /// How far beyond the clamp of displacements a sheet that bends is held in its slope.
  double slope_margin_A() const { return slope_margin_A_; }

  /// Radius of the continuum's disc with the area of the loaded atoms, c = √(N A_atom / π).
  double effective_tip_A(const atomistic::Load& load) const;

  /// Imposed on the flat sheet: the pretension.
  double biaxial_strain() const { return strain_; }

 private:
  double strain_;
  atomistic::Sheet sheet_;
  double slope_margin_A_ = 0;
  Eigen::Vector2d half_A_ = Eigen::Vector2d::Zero();
};

}  // namespace validate
