// Many measured curves on all cores: read one at a time, each fitted or skipped with its reason.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compare/cli/fit_flags.hpp"
#include "compare/results/result.hpp"

namespace validate {

/// Calls work(i) for i < n on all cores this process may use. What work throws ends all, and is thrown here; so does a
/// signal (Error, interrupted).
void on_all_cores(std::size_t n, const std::function<void(std::size_t)>& work);

/// Files, and of folders the files in them in the order of their names. Throws Error (bad input) for a folder without
/// files.
std::vector<std::string> files_of(const std::vector<std::string>& names);

/// Fits every curve of the files: `many` with a row each, means and the joint fit, where there are more than one;
/// `curves` in full where there are few; `unfitted` what could not be read or fitted. Rows are kept in `partial` as
/// they come, and taken from there with `flags.resume`. Throws the first error where no curve at all could be fitted.
void fit_curves(const FitFlags& flags, const std::optional<PotentialCard>& card,
                const std::optional<std::filesystem::path>& partial, Result& result);

}  // namespace validate
