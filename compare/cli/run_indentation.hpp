// The run of `validate indentation` once its case is complete and checked.
#pragma once

#include <optional>

#include "compare/input/case.hpp"
#include "compare/input/potential_file.hpp"
#include "compare/input/run_options.hpp"

namespace validate {

/// Runs the comparison and returns the exit code. The potential is absent for a membrane with given
/// constants.
int run_indentation(const Case&, const RunOptions&, const std::optional<PotentialFile>&);

}  // namespace validate
