// What a temperature does to finished atomistic paths, computed side by side.
#pragma once

#include <string>
#include <vector>

#include "atomistic/temperature.hpp"
#include "compare/process/atoms_curves.hpp"

namespace validate {

struct HeatedCurve {
  std::vector<atomistic::HeatedLevel> levels;  ///< of the path's equilibria, in order
  std::string failure;                         ///< of the program; empty: it came to its end
  ExitCode failure_code = ExitCode::atomistic_failed;
};

/// Heats the steps in `work`/<name>/steps with `ranks` each; levels that an earlier run has finished are taken over.
/// Throws Error (interrupted).
std::vector<HeatedCurve> heat_curves(const AtomsLaunch& launch, const std::vector<AtomsPath>& paths,
                                     const atomistic::Heat& heat, int ranks, const std::filesystem::path& work,
                                     Progress& progress);

}  // namespace validate
