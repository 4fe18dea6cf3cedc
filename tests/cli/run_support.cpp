#include "tests/cli/run_support.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <stdexcept>
#include <thread>

#include "tests/support/json_schema.hpp"

namespace cli_tests {

namespace fs = std::filesystem;
using nlohmann::json;

Words small_run(const Words& more) {
  Words words = {"indentation", "--radius",     "15", "--potential", "tersoff", "--tip-radius",
                 "5",           "--depth-step", "1",  "--depth-max", "4"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

json document(const fs::path& file) {
  std::ifstream in(file);
  return json::parse(in);
}

void expect_valid(const json& document, const std::string& schema) {
  const support::JsonSchema parsed(support::read_json(SOURCE_INPUTS "/" + schema + ".schema.json"));
  EXPECT_EQ(parsed.problems(document), Words{});
}

void expect_says(const Outcome& outcome, int exit_code, const Words& words) {
  EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
  for (const std::string& word : words)
    EXPECT_NE(outcome.err.find(word), std::string::npos) << "'" << word << "' is not in: " << outcome.err;
}

const json& run_of(const json& summary, const std::string& model, const std::string& load,
                   const std::string& constants) {
  for (const json& run : summary.at("runs"))
    if (run.at("model") == model && run.at("load") == load &&
        (run.at("constants").is_null() ? constants.empty() : run.at("constants") == constants))
      return run;
  throw std::runtime_error("no such run: " + model + " " + load);
}

std::vector<std::string> processes_of(const fs::path& folder) {
  std::vector<std::string> found;
  for (const auto& entry : fs::directory_iterator("/proc")) {
    std::ifstream in(entry.path() / "cmdline", std::ios::binary);
    const std::string line{std::istreambuf_iterator<char>(in), {}};
    if (line.find(folder.string()) != std::string::npos) found.push_back(line);
  }
  return found;
}

bool none_left(const fs::path& folder) {
  for (int i = 0; i < 100 && !processes_of(folder).empty(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  return processes_of(folder).empty();
}

bool appears(const fs::path& file) {
  for (int i = 0; i < 600 && !fs::exists(file); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  return fs::exists(file);
}

}  // namespace cli_tests
