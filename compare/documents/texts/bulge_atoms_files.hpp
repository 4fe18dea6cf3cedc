// What the atoms add to a bulge run's documents.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "compare/study/bulge_atoms.hpp"

namespace validate {

nlohmann::ordered_json bulge_atoms_document(const BulgeAtoms& atoms);

/// One row a pressure.
std::string bulge_atoms_csv(const BulgeAtoms& atoms);

std::string bulge_atoms_table(const BulgeAtoms& atoms);

/// atoms.svg and .png: depth against pressure of both where there is more than one, and both cross-sections. A warning
/// where gnuplot is missing or complains.
std::optional<std::string> draw_bulge_atoms(const BulgeAtoms& atoms, const std::filesystem::path& folder);

}  // namespace validate
