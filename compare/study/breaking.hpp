// Where a path of atoms broke, and where the sheet beside it tears.
#pragma once

#include <optional>
#include <vector>

#include "atomistic/problem.hpp"
#include "compare/results/result.hpp"

namespace validate {

/// The steps that make the curve: those on the way there in the order of their levels, the tries between the last that
/// was borne and the first that broke among them as far as they were borne; of the broken ones the first alone.
std::vector<const atomistic::Step*> steps_of_curve(const std::vector<atomistic::Step>& steps);

/// From the steps of a path; nothing where none broke, or none was borne before. `artefact_bond_A` is the potential's.
std::optional<Breaking> breaking_of(const std::vector<atomistic::Step>& steps, double artefact_bond_A);

/// Puts the calibrated sheet's end beside the atoms' of the same load, and the judged load's into the verdict.
void compare_breaking(Result& result);

}  // namespace validate
