// Dynamics of finished atomistic levels, several side by side.
#pragma once

#include <string>
#include <vector>

#include "atomistic/temperature.hpp"
#include "compare/process/atoms_curves.hpp"

namespace validate {

struct SampledCurve {
  std::vector<atomistic::Sampled> levels;  ///< in order; those that failed are missing
  std::string failure;
  ExitCode failure_code = ExitCode::atomistic_failed;
};

/// Samples every equilibrium in `work`/<name>/steps, one rank each; what an earlier run has sampled is taken over.
/// Throws Error (interrupted).
std::vector<SampledCurve> sample_levels(const AtomsLaunch& launch, const std::vector<AtomsPath>& paths,
                                        const atomistic::Sampling& sampling, const std::filesystem::path& work,
                                        Progress& progress);

}  // namespace validate
