// Leaf results into runs: the columns of a curve, one step at a time.
#pragma once

#include <optional>

#include "atomistic/problem.hpp"
#include "compare/potential/law/calibrated_law.hpp"
#include "compare/results/result.hpp"
#include "compare/study/wrinkles.hpp"
#include "membrane/problem.hpp"

namespace validate {

void append(Run& run, const membrane::Step& step);

/// What the last point's sheet is wrinkled by.
void append(Run& run, const Wrinkles& wrinkles);

/// Of a meridian, with the longest bond that its strains predict, where the law knows it. `stretch` is the flat
/// sheet's.
void append(Run& run, const membrane::Step& step, const std::optional<LongestBond>& longest_bond, double stretch);

/// `artefact_from_A` is the potential's own length from which forces are an artefact. A broken sheet counts as one that
/// has not converged: nothing is to be read from it.
void append(Run& run, const atomistic::Step& step, double artefact_from_A, bool broken);

/// The way back, after `run` holds the way there. The lost work is integrated by the trapezoidal rule over both, which
/// share their depths, so that the rule's error cancels; the depth common to both is the range.
Unloading unloading_of(const Run& run, const std::vector<atomistic::Step>& steps);

void close(Run& run, const membrane::Report& report);
void close(Run& run, const atomistic::Report& report);

}  // namespace validate
