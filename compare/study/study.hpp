// The comparison itself: card, curves of both models, fits and verdict, for one case.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "atomistic/lattice/sheet.hpp"
#include "compare/base/errors.hpp"
#include "compare/base/progress.hpp"
#include "compare/input/case.hpp"
#include "compare/input/potential_file.hpp"
#include "compare/process/atoms.hpp"
#include "compare/results/result.hpp"

namespace validate {

struct StudyOptions {
  AtomsLaunch launch;
  int ranks = 0;                 ///< per curve; 0: chosen from the cores and the size of the sheet
  std::filesystem::path folder;  ///< of the run; holds `work`
  bool all_fields = false;       ///< keep the membranes' sheets at every depth, not at the last only
  int curves_at_once = 0;        ///< for which there is memory; 0: all
};

/// What a study produced, and what failed on the way: nothing computed is lost to a failure.
struct StudyOutcome {
  Result result;
  std::optional<atomistic::Sheet> sheet;  ///< where atoms were asked for
  atomistic::Potential potential;         ///< that they have
  std::string failure;                    ///< of the atomistic program; empty: none
  ExitCode failure_code = ExitCode::atomistic_failed;
};

/// Runs the case: card, pair, levels, solve, judge. `potential` is there unless the case has its own constants. The
/// result's exit code is settled; what failed has been told in it, too.
StudyOutcome run_study(Command command, const Case& c, const std::optional<PotentialFile>& potential,
                       const StudyOptions& options, Progress& progress);

}  // namespace validate
