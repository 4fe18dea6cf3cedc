// Recorded curves as HDF5.
#pragma once

#include <filesystem>
#include <vector>

#include "compare/results/recording.hpp"

namespace validate {

/// Groups 0, 1, … of one curve each: metadata as attributes, columns as data sets with an attribute `unit`, `segment`
/// the number of each point's segment. Whole or not at all. Throws Error (file failed).
void write_recordings_h5(const std::vector<Recording>& recordings, const std::filesystem::path& file);

}  // namespace validate
