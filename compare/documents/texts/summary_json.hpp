// summary.json: what a run found, for programs. Described by inputs/summary.schema.json.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "compare/results/result.hpp"

namespace validate {

inline constexpr int summary_schema = 1;

/// The document. Numbers that are not known or not finite, and texts that are empty, are null.
nlohmann::ordered_json summary_document(const Result& result);

/// The resolved case, as it stands in the document.
nlohmann::ordered_json case_document(const Case& resolved);

/// A fit, as it stands in the document of a run or of `validate fit`.
nlohmann::ordered_json fit_document(const Fit& fit);

void write_summary(const Result& result, const std::filesystem::path& folder);

/// Throws Error (file failed) if `--json` names what cannot be written: to be known before the work, not after it.
void check_json_target(const std::string& target);

/// The same document for `--json`: a file, or "-" for stdout. Throws Error (file failed).
void write_json(const Result& result, const std::string& target);

}  // namespace validate
