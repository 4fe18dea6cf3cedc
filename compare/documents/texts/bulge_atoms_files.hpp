// What the atoms add to a bulge run's documents.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "compare/study/bulge_atoms.hpp"

namespace validate {

nlohmann::ordered_json bulge_atoms_document(const BulgeAtoms& atoms);

/// One row a pressure.
std::string bulge_atoms_csv(const BulgeAtoms& atoms);

std::string bulge_atoms_table(const BulgeAtoms& atoms);

}  // namespace validate
