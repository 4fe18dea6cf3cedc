// --dry-run: what a case would compute, and about how long that takes.
#pragma once

#include <optional>
#include <string>

#include "compare/input/case.hpp"
#include "compare/input/potential_file.hpp"
#include "compare/process/atoms.hpp"

namespace validate {

/// The resolved case, atom and triangle counts and an estimate, as text. Starts no program.
std::string plan_text(const Case& c, const std::optional<PotentialFile>& potential, const AtomsLaunch& launch);

}  // namespace validate
