// The atoms' trajectories in HDF5, by H5MD 1.1.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compare/documents/bytes/h5.hpp"
#include "compare/results/trajectory.hpp"

namespace validate {

/// Groups h5md, particles and observables under the root, `load` as their subgroup; nothing without trajectories.
void write_trajectories(h5::Group& root, const std::vector<AtomsTrajectory>& trajectories, const std::string& version);

/// Those of a run.h5; none where there is no such file, or where it holds none. Throws Error (file failed) where
/// lengths do not fit each other.
std::vector<AtomsTrajectory> read_trajectories(const std::filesystem::path& file);

}  // namespace validate
