// What `validate fit` prints and writes.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compare/fitting/measured_fit.hpp"

namespace validate {

/// One block per curve: the numbers with their errors, bias, correction, membrane, warnings.
std::string measured_text(const MeasuredResult& result, const MeasuredOptions& options);

/// All curves of a command, each with its options; described by inputs/fit.schema.json.
nlohmann::ordered_json measured_document(const std::vector<MeasuredResult>& results,
                                         const std::vector<MeasuredOptions>& options, const std::string& command_line);

}  // namespace validate
