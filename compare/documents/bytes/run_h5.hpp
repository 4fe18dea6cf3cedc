// run.h5: the result tree as groups, attributes and data sets, with units and meanings.
#pragma once

#include <filesystem>
#include <vector>

#include "compare/results/result.hpp"
#include "compare/results/trajectory.hpp"

namespace validate {

/// Writes the result, whole or not at all. A struct is a group, a list of them a group of groups 0, 1, …; values are
/// attributes, columns data sets. Trajectories of its atoms, if there are any, stand beside it by H5MD. Throws Error
/// (file failed).
void write_run_h5(const Result& result, const std::filesystem::path& file,
                  const std::vector<AtomsTrajectory>& trajectories = {});

}  // namespace validate
