// The membrane of a run once more, for what its curve does not hold: the stress from the centre to the rim.
#pragma once

#include <optional>

#include "compare/results/result.hpp"
#include "compare/results/round_field.hpp"

namespace validate {

/// Solves the like-for-like membrane of the judged load (or the one with given constants) in one dimension up to its
/// deepest usable depth. Nothing where there is no such run.
std::optional<RoundField> deepest_round_field(const Result& result);

}  // namespace validate
