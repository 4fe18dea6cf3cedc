// run.h5: everything that a run found, with units, for h5py and other HDF5 readers.
#pragma once

#include <filesystem>

#include "compare/results/result.hpp"

namespace validate {

/// Groups: /case (what was asked for), /sheet, /card, /runs/0 … (attributes, one data set per column with
/// `unit` and `meaning`, group fit), /agreement, /timing, /provenance. What is not known is NaN or left out.
void write_run_h5(const Result& result, const std::filesystem::path& folder);

}  // namespace validate
