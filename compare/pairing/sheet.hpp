// The sheet that the atoms of a case form, and the continuum's lengths that belong to it.
#pragma once

#include <Eigen/Core>

#include "atomistic/lattice/sheet.hpp"
#include "atomistic/problem.hpp"
#include "compare/input/case.hpp"

namespace validate {

class PairedSheet {
 public:
  /// Throws Error (bad input) for a sheet too small for a lattice.
  PairedSheet(const Case& c, const atomistic::Potential& potential, const atomistic::Card& card);

  const atomistic::Sheet& sheet() const { return sheet_; }

  /// Half lengths of the continuum along x and y (of a disc: its radius twice). Clamped: a margin of 0.75 bonds around
  /// the free sheet; sliding: where the outermost atoms are, which the supports hold at z = 0.
  const Eigen::Vector2d& half_A() const { return half_A_; }
  double effective_radius_A() const { return half_A_.x(); }

  /// Radius of the continuum's disc with the area of the loaded atoms, c = √(N A_atom / π).
  double effective_tip_A(const atomistic::Load& load) const;

  /// Imposed on the flat sheet: the pretension.
  double biaxial_strain() const { return strain_; }

 private:
  double strain_;
  atomistic::Sheet sheet_;
  Eigen::Vector2d half_A_ = Eigen::Vector2d::Zero();
};

}  // namespace validate
