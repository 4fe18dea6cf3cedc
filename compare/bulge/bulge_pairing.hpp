// What makes a pressurised sheet of atoms and a membrane the same experiment.
#pragma once

#include <Eigen/Core>

#include "atomistic/sheet.hpp"
#include "compare/bulge/bulge_case.hpp"

namespace compare {

struct BulgePair {
  atomistic::Sheet sheet;
  atomistic::Problem atoms;
  membrane::Problem membrane;
  Eigen::Vector2d size_A;  ///< of the membrane: lengths of the rectangle, diameter of the disc twice
};

/// The atoms fill the case's disc or square under its follower pressures. The membrane has the card's constants and
///   clamped: a margin of 0.75 bonds around the free atoms' disc or square, as under an indenter;
///   sliding: its edges where the sheet's outermost atoms are, which the supports hold at z = 0;
///   both: the depth of record at one bond from the axis (on a square's grid: the centre), the case's pretension, imposed on
///   the atoms as biaxial strain.
/// Throws Error (bad input) for a sheet too small for a lattice.
BulgePair pair_bulge(const BulgeCase& c, const atomistic::Potential& potential, const atomistic::Card& card);

}  // namespace compare
