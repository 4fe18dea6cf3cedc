// The sheets of a run, as the page shows them in three dimensions: atoms and membrane of each load, depth by depth.
#pragma once

#include <string>
#include <vector>

#include "compare/results/result.hpp"
#include "compare/results/trajectory.hpp"

namespace validate {

/// Atoms beside the membrane that is like for like with them (or the given one, or any that was kept); positions are
/// rounded to a few thousandths of an Å. What would take a page beyond `budget_bytes` is thinned out: every second
/// depth is left out, until it fits. Empty where there is nothing to be seen.
std::string sheets_json(const Result& result, const std::vector<AtomsTrajectory>& atoms,
                        std::size_t budget_bytes = 1'600'000);

}  // namespace validate
