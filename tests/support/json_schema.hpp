// A JSON Schema (draft 7) that documents are checked against.
#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace support {

/// Reads a JSON file. Throws std::runtime_error naming the file if it cannot be read or is not JSON.
nlohmann::json read_json(const std::filesystem::path& file);

class JsonSchema {
 public:
  explicit JsonSchema(const nlohmann::json& schema);
  ~JsonSchema();

  /// What is wrong with the document, one line per problem; empty if it is valid.
  std::vector<std::string> problems(const nlohmann::json& document) const;

 private:
  struct Parsed;
  std::unique_ptr<Parsed> parsed_;
};

}  // namespace support
