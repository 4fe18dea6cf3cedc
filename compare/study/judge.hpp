// What is made of a study's curves once they are solved.
#pragma once

#include <map>
#include <vector>

#include "compare/fitting/run_fit.hpp"
#include "compare/pairing/pairing.hpp"
#include "compare/study/study.hpp"
#include "compare/verdict/explanation.hpp"

namespace validate {

/// Hands the curves over to the result (atoms, then triangles, then the calibrated continua) and fits, explains,
/// compares and judges them.
void judge_all(std::vector<PairedLoad>& loads, const std::map<LoadKind, Anisotropy>& anisotropies,
               const LadderPhysics& ladder, StudyOutcome& outcome);

/// The exit code that a study ends with, and why: what failed; a solver that gave up; a verdict that is not agreement.
void settle_exit(StudyOutcome& outcome);

}  // namespace validate
