// What is reported of an equilibrium.
#pragma once

#include <Eigen/Core>

#include "membrane/meridian/assembly.hpp"
#include "membrane/meridian/sheet.hpp"

namespace membrane::axisymmetric {

/// Shape, energies, strains, forces and reactions of x; what belongs to the path is left for it to fill in.
SheetStep record(const SheetProblem& problem, Assembly& assembly, const Eigen::VectorXd& x);

}  // namespace membrane::axisymmetric
