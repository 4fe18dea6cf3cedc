// --dry-run: what a case would compute, and about how long that takes.
#pragma once

#include <optional>
#include <string>

#include "compare/atoms.hpp"
#include "compare/case.hpp"
#include "compare/potential_file.hpp"

namespace compare {

/// The resolved case, atom and triangle counts and an estimate, as text. Starts no program.
std::string plan_text(const Case& c, const std::optional<PotentialFile>& potential, const AtomsLaunch& launch);

}  // namespace compare
