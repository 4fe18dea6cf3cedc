// Published numbers with ours beside them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compare/base/progress.hpp"
#include "compare/process/atoms.hpp"
#include "compare/published/entry.hpp"
#include "compare/results/published.hpp"

namespace validate::published {

/// What computing ours may use.
struct Means {
  std::filesystem::path potentials;  ///< folder with their descriptions
  std::vector<std::string> chosen;   ///< potentials of the rows that name none …
  bool chosen_alone = false;         ///< … and the only ones of those that do
  AtomsLaunch launch;
  std::filesystem::path cards;  ///< cache; empty: none
  Progress& progress;
};

/// A row for each entry and potential, in their order. Each card, and each figure of the paper, is made once. Throws
/// Error: bad input for a potential that is none or a number that its figure lacks; as cards and figures do.
std::vector<PublishedRow> compared(const std::vector<Entry>& entries, const Means& means);

}  // namespace validate::published
