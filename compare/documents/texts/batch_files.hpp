// The documents of a batch: every case's summary in one, and a table of them.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace validate {

/// One case as its documents tell it.
struct BatchEntry {
  std::string potential;
  double radius_A = 0;
  std::string folder;              ///< name, below the batch's
  int exit_code = 0;               ///< as if it had been run alone
  nlohmann::ordered_json summary;  ///< its summary.json; null where it failed before there was one
};

/// summary.json of a batch (batch.schema.json).
nlohmann::ordered_json batch_document(const std::vector<BatchEntry>& entries);

/// One row for each curve of atoms, or for a case that failed.
std::string batch_table(const std::vector<BatchEntry>& entries);

}  // namespace validate
