// One case from start to finish: run folder, study, documents, exit code.
#pragma once

#include <optional>

#include "compare/input/case.hpp"
#include "compare/input/potential_file.hpp"
#include "compare/input/run_options.hpp"
#include "compare/results/result.hpp"

namespace validate {

/// `potential` is there unless the case has its own constants. Returns the exit code; throws Error for what ends a run
/// without one.
int run_experiment(Command command, const Case& c, const RunOptions& options,
                   const std::optional<PotentialFile>& potential);

}  // namespace validate
