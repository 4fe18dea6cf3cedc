// Several cases of an experiment side by side.
#pragma once

#include <string>
#include <vector>

#include "compare/input/run_options.hpp"
#include "compare/results/result.hpp"

namespace validate {

struct BatchCase {
  std::string potential;
  double radius_A = 0;
  std::vector<std::string> words;  ///< the flags that make it this case
};

/// Runs each case as a process of this program in a folder of its own below --out (runs/<command>-batch by
/// default), one core each, as many at a time as there are cores. With --resume finished cases are kept,
/// unfinished ones go on. Writes summary.json with `cases` and prints one row per case. Returns the largest
/// exit code of the cases. Throws Error: bad input for a folder in use; interrupted after stopping all cases.
int run_batch(Command command, const std::vector<BatchCase>& cases, const std::vector<std::string>& common,
              const RunOptions& options);

}  // namespace validate
