// What `validate fit` prints, draws and writes.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "compare/fitting/measured_fit.hpp"

namespace validate {

/// One block per curve: the numbers with their errors, bias, correction, membrane, warnings.
std::string measured_text(const MeasuredResult& result, const MeasuredOptions& options);

/// All curves of a command, each with its options; described by inputs/fit.schema.json.
nlohmann::ordered_json measured_document(const std::vector<MeasuredResult>& results,
                                         const std::vector<MeasuredOptions>& options, const std::string& command_line);

/// fit-<name>.svg and .png: data with both fits, residuals, window scan. Returns what the user should know,
/// if anything.
std::optional<std::string> draw_measured(const MeasuredResult& result, const MeasuredOptions& options,
                                         const std::filesystem::path& folder, const std::string& name);

}  // namespace validate
