// What `validate potential` leaves and prints.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "compare/results/result.hpp"

namespace validate {

std::string card_table(const Result& result);

/// `card.json`, `run.h5`, `stress-strain.csv`, `stress-strain.svg` and `.png`, `law.toml` in a folder that exists.
/// Returns what is missing where gnuplot is not installed. Throws Error (file failed).
std::optional<std::string> write_card_files(const Result& result, const std::filesystem::path& folder);

}  // namespace validate
