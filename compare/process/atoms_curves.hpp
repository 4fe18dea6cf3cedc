// Atomistic paths computed side by side, each to its end or to what stopped it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/base/errors.hpp"
#include "compare/base/progress.hpp"
#include "compare/process/atoms.hpp"

namespace validate {

/// A path to follow; the name is its folder below `work`.
struct AtomsPath {
  std::string name;
  atomistic::Problem problem;
  bool keep_positions = false;  ///< of every step, not of the last alone
};

struct AtomsCurve {
  std::vector<atomistic::Step> steps;  ///< finished ones, those of an interrupted run included; forces, virials and
                                       ///< (unless they are to be kept) positions of the last alone
  std::optional<atomistic::Report> report;
  std::string failure;  ///< of the program; empty: it came to its end
  ExitCode failure_code = ExitCode::atomistic_failed;
  std::string lammps;  ///< release
};

/// Ranks that a curve of this many atoms is worth when `side_by_side` of them share the cores: 1 without mpiexec or
/// under a launcher of the user's.
int useful_ranks(const AtomsLaunch& launch, int atoms, int side_by_side);

/// Runs the paths in `work`/<name> with `ranks` each, steps finished earlier taken over. Throws Error (interrupted).
std::vector<AtomsCurve> compute_curves(const AtomsLaunch& launch, const std::vector<AtomsPath>& paths, int ranks,
                                       const std::filesystem::path& work, Progress& progress);

}  // namespace validate
