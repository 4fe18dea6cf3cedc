// The states of equilibrium that a pressurised square of atoms is found in, from several starts.
#pragma once

#include <string>
#include <vector>

#include "compare/figures/paper_figure.hpp"
#include "compare/pairing/pairing.hpp"
#include "compare/process/atoms.hpp"

namespace validate {

/// The square as atoms, and its membrane with the card's constants.
struct PairedSquare {
  atomistic::Sheet sheet;
  atomistic::Problem atoms;
  membrane::Problem membrane;
  Eigen::Vector2d size_A;  ///< lengths of the membrane
};

PairedSquare paired_square(const Case& c, const PotentialFile& file, const PotentialCard& card);

/// One search and where it ended.
struct Found {
  std::string start;
  atomistic::Step step;
  int evaluations = 0;
  double potential_eV = 0;  ///< energy minus pressure times volume
  double left_eV = 0;       ///< estimate of what a longer search would gain
  std::string path;         ///< depths at the smaller pressures on the way
};

/// The starts, context.starts of them:
///   0: up through smaller pressures, along the branch that begins flat;
///   1: the full pressure at once;
///   2, …: the full pressure at once on a sheet with random ripples of 0.5 Å.
/// Lowest potential first; a search that did not come to the full pressure is left out. Throws Error: atomistic failed;
/// not converged where none came there; interrupted.
std::vector<Found> search_states(const PairedSquare& pair, double pressure_eV_per_A3, const AtomsLaunch& launch,
                                 const FigureContext& context);

}  // namespace validate
