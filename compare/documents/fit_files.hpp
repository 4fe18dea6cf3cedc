// The documents of `validate fit`.
#pragma once

#include <filesystem>

#include "compare/results/result.hpp"

namespace validate {

/// fit.json, run.h5 and for each curve fit-<name>.svg, .png and .csv (what is drawn) in an existing folder. Throws
/// Error (file failed).
void write_fit_files(const Result& result, const std::filesystem::path& folder);

}  // namespace validate
