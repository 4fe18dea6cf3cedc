// What `validate potential` leaves and prints: JSON, table, stress–strain curves as CSV and figure.
#pragma once

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "compare/potential/potential_card.hpp"

namespace validate {

/// The card in both unit systems; every name ends in its unit, what is not known is null.
nlohmann::ordered_json card_document(const PotentialCard& card);

std::string card_table(const PotentialCard& card);

/// `card.json`, `stress-strain.csv`, `stress-strain.svg` and `.png` in a folder that exists. Returns what is missing
/// where gnuplot is not installed. Throws Error (file failed).
std::optional<std::string> write_card_files(const PotentialCard& card, const std::filesystem::path& folder);

}  // namespace validate
