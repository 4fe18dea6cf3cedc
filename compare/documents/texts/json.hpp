// The result tree as JSON: keys are the names of describe() with their units behind them, what is not known is null.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "compare/results/result.hpp"

namespace validate {

nlohmann::ordered_json document(const Result& result);
nlohmann::ordered_json document(const Case& resolved);

/// The document as text, a final newline included. A path or a command line need not be UTF-8: its foreign bytes become
/// replacement characters.
std::string json_text(const Result& result);

/// Refuses a `--json` target that could not be written, before anything is computed: see check_users_file().
void check_json_target(const std::string& target);

/// Writes the document to the user's file, or to stdout for "-". Throws Error (file failed).
void write_json(const Result& result, const std::string& target);

}  // namespace validate
