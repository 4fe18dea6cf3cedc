// Leaf results into runs: the columns of a curve, one step at a time.
#pragma once

#include "atomistic/problem.hpp"
#include "compare/result.hpp"
#include "membrane/problem.hpp"

namespace compare {

void append(Run& run, const membrane::Step& step);

/// `artefact_from_A` is the potential's own length from which forces are an artefact.
void append(Run& run, const atomistic::Step& step, double artefact_from_A);

void close(Run& run, const membrane::Report& report);
void close(Run& run, const atomistic::Report& report);

}  // namespace compare
