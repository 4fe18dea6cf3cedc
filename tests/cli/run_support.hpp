// What the tests of whole runs share.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/cli/run_program.hpp"

namespace cli_tests {

using Words = std::vector<std::string>;

/// A small, cheap comparison.
Words small_run(const Words& more);

nlohmann::json document(const std::filesystem::path& file);

/// Against a schema of inputs/.
void expect_valid(const nlohmann::json& document, const std::string& schema = "summary");

/// Exit code, and words that the message must hold.
void expect_says(const Outcome& outcome, int exit_code, const Words& words);

const nlohmann::json& run_of(const nlohmann::json& summary, const std::string& model, const std::string& load,
                             const std::string& constants = {});

/// Every process whose command line names this folder.
std::vector<std::string> processes_of(const std::filesystem::path& folder);
bool none_left(const std::filesystem::path& folder);  ///< waits up to 10 s
bool appears(const std::filesystem::path& file);      ///< waits up to 30 s

}  // namespace cli_tests
