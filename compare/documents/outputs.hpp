// The run folder's files.
#pragma once

#include <filesystem>

#include "compare/results/result.hpp"

namespace validate {

/// Writes every document of the list in outputs.cpp into an existing folder, each complete or not at all. One
/// that fails does not keep the others from being written; the first failure is thrown at the end (Error,
/// file failed). What only a missing gnuplot prevents is a warning in the log.
void write_all(const Result& result, const std::filesystem::path& folder);

}  // namespace validate
