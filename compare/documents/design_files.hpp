// The documents of a planned experiment.
#pragma once

#include <filesystem>

#include "compare/results/result.hpp"

namespace validate {

/// design.json and design.svg, .png, .csv. Throws Error (file failed).
void write_design_files(const Result& result, const std::filesystem::path& folder);

}  // namespace validate
