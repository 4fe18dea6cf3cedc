// What the case's temperature does to the atoms' curves.
#pragma once

#include <vector>

#include "compare/pairing/pairing.hpp"
#include "compare/potential/warm_sheet.hpp"
#include "compare/process/atoms_curves.hpp"
#include "compare/study/study.hpp"

namespace validate {

/// How a case heats its atoms.
atomistic::Heat heat_of(const Case& c);

/// In words and numbers of a result.
WarmSheet summary_of(const atomistic::WarmCard& warm, const atomistic::Card& card);

/// Heats the curves of the loads, which have been computed at T = 0 along `paths`, and puts the answer into their runs.
/// With the rim at the temperature's lattice constant the paths are followed once more from there. What failed is told
/// in the outcome. Nothing without a temperature. Throws Error (interrupted).
void heat_atoms(std::vector<PairedLoad>& loads, const std::vector<AtomsPath>& paths,
                const std::vector<AtomsCurve>& curves, int ranks, const StudyOptions& options, StudyOutcome& outcome,
                Progress& progress);

}  // namespace validate
