// Many runs of this program side by side, each a process with a folder and cores of its own.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compare/base/progress.hpp"

namespace validate {

struct ManyCase {
  std::string name;                ///< in the progress
  std::vector<std::string> words;  ///< program and arguments; --out, --quiet and --resume come from here
  std::filesystem::path folder;    ///< of its run
  std::filesystem::path log;       ///< takes its standard error
  int cores = 1;                   ///< that it wants; it runs on these alone, and plans for no others
};

/// How a case ended.
struct CaseEnd {
  int exit_code = 0;  ///< as if it had been run alone; 128 + signal where a signal ended it
  double seconds = 0;
  std::string reason;            ///< of an end without a verdict: signal, why it did not start, or its log's last line
  bool finished_before = false;  ///< in an earlier run of these cases: only its exit code is told again
};

/// Numbers of the cores that this process may use.
std::vector<int> usable_cores();

/// Starts the cases in their order, as many at a time as `cores` hold, and waits for all; a case that wants more cores
/// than there are gets all of them. What one case fails at is its own end. With `resume` a case whose folder holds a
/// finished run is kept, and an unfinished one goes on. Returns one end a case, in their order. Throws Error
/// (interrupted) after stopping every case when a signal has come.
std::vector<CaseEnd> run_cases(const std::vector<ManyCase>& cases, bool resume, Progress& progress,
                               const std::vector<int>& cores = usable_cores());

}  // namespace validate
