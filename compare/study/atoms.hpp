// The atomistic curves of a study, each a process of its own.
#pragma once

#include <vector>

#include "atomistic/lattice/sheet.hpp"
#include "compare/base/progress.hpp"
#include "compare/pairing/pairing.hpp"
#include "compare/study/study.hpp"

namespace validate {

/// Computes the curves side by side in the folder's `work`, takes over what an earlier run has finished, and fills the
/// loads' runs, the way back, timing and what failed into the outcome. Throws Error (interrupted).
void compute_atoms(std::vector<PairedLoad>& loads, const atomistic::Sheet& sheet, const StudyOptions& options,
                   StudyOutcome& outcome, Progress& progress);

}  // namespace validate
