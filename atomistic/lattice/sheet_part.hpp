// One rank's part of a sheet.
#pragma once

#include <vector>

#include "atomistic/lattice/sheet.hpp"

namespace atomistic {

/// A sheet as far as one rank needs it: its own free atoms, then the free atoms of others within two bonds of them,
/// then the clamped ones within two bonds. In each group in the order of the whole sheet. What a neighbour's neighbour
/// is bonded to beyond is left out.
struct SheetPart {
  Sheet sheet;             ///< its free atoms are the own
  int ghosts = 0;          ///< free atoms of others, after the own
  std::vector<int> ids;    ///< of all its atoms, in the whole sheet
  std::vector<int> owner;  ///< of the ghosts: which rank has each as its own, …
  std::vector<int> place;  ///< … and as its which
};

/// `owner`: of the whole sheet's free atoms. Innermost and record atoms are those of the own.
SheetPart part_of(const Sheet& whole, const std::vector<int>& owner, int rank);

/// Threes of numbers of the whole sheet's atoms: those of the part's.
Eigen::VectorXd part_of(const Eigen::VectorXd& whole, const SheetPart& part);

}  // namespace atomistic
