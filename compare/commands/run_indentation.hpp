// The run of `validate indentation` once its case is complete and checked.
#pragma once

#include <optional>

#include "compare/case.hpp"
#include "compare/commands/run_options.hpp"
#include "compare/potential_file.hpp"

namespace compare {

/// Runs the comparison and returns the exit code. The potential is absent for a membrane with given
/// constants.
int run_indentation(const Case&, const RunOptions&, const std::optional<PotentialFile>&);

}  // namespace compare
