// The tension inside a flat sheet of atoms whose rim is pulled: a free edge of a lattice has a stress of its own, and
// pulls or pushes beside the dead force.
#pragma once

#include <vector>

#include "compare/base/progress.hpp"
#include "compare/pairing/pairing.hpp"
#include "compare/potential/potential_card.hpp"
#include "compare/study/study.hpp"

namespace validate {

/// Biaxial Green–Lagrange strain of the atoms from two to six tenths of the radius: half of the mean square of the
/// bonds' stretch, less one.
double strain_inside(const atomistic::Sheet& sheet, const Eigen::VectorXd& positions);

/// Lets the atoms settle under the rim's force, and a larger one, and next to no load, and reads the tensions inside
/// from their bonds by the potential's own law (its constants, where there is none). What is missing there of the
/// applied tension, times the radius, is the force of the edge: at the applied tension it is given to the continua, its
/// stress and stiffness in the flat sheet are written into the result's. False, and the failure in the outcome, where
/// the atoms do not settle.
bool measure_flat_tension(std::vector<PairedLoad>& loads, const PotentialCard& card, const StudyOptions& options,
                          StudyOutcome& outcome, Progress& progress);

}  // namespace validate
