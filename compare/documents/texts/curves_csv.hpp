// curves.csv: all curves in one long table, for spreadsheets and scripts.
#pragma once

#include <filesystem>
#include <string>

#include "compare/results/result.hpp"

namespace validate {

/// Lines "# key: value" (units, constants and radii of each run), a header, then one row per run and depth. A
/// cell is empty where the model has no such column or the number is not known.
std::string curves_csv(const Result& result);

void write_curves(const Result& result, const std::filesystem::path& folder);

}  // namespace validate
