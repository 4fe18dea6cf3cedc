// Where a continuum expects the atoms: the start of a level, nothing that its result would depend on.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "atomistic/lattice/sheet.hpp"
#include "atomistic/problem.hpp"

namespace atomistic {

/// Displacements (3 per free atom) that a problem's guide for this level gives; nothing where there is none.
std::optional<Eigen::VectorXd> guided_displacement(const Problem& problem, const Sheet& sheet, double level);

}  // namespace atomistic
