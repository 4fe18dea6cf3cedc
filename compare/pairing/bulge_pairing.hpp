// What makes a pressurised sheet of atoms and a membrane the same experiment.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "atomistic/lattice/sheet.hpp"
#include "compare/input/bulge_case.hpp"
#include "compare/potential/potential_card.hpp"
#include "membrane/meridian/sheet.hpp"

namespace validate {

struct BulgePair {
  std::optional<membrane::axisymmetric::SheetProblem>
      calibrated;  ///< a clamped disc of the potential's own law that bends
  atomistic::Sheet sheet;
  atomistic::Problem atoms;
  membrane::Problem membrane;
  Eigen::Vector2d size_A;  ///< of the membrane: lengths of the rectangle, diameter of the disc twice
};

/// The atoms fill the case's disc or square under its follower pressures. The membrane has the card's constants and
///   clamped: a margin of 0.75 bonds around the free atoms' disc or square, as under an indenter;
///   sliding: its edges where the sheet's outermost atoms are, which the supports hold at z = 0;
///   both: the depth of record at one bond from the axis (on a square's grid: the centre), the case's pretension,
///   imposed on the atoms as biaxial strain.
/// A clamped disc has a calibrated sheet beside it, whose shapes the atoms start from.
/// Throws Error (bad input) for a sheet too small for a lattice.
BulgePair pair_bulge(const BulgeCase& c, const PotentialCard& card);

}  // namespace validate
