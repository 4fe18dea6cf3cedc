// Cuts through a deformed sheet along x, to be drawn beside each other.
#pragma once

#include <Eigen/Core>

#include "atomistic/lattice/sheet.hpp"
#include "compare/results/run.hpp"
#include "compare/results/sheet_columns.hpp"

namespace validate {

/// Of a sheet of atoms at these positions (3N, Å): those within 0.6 bonds of the line y = 0 in the flat sheet.
CrossSection cross_section(const atomistic::Sheet& sheet, const Eigen::VectorXd& positions);

/// Of a membrane: the nodes on y = 0, mirrored where the mesh is a quarter.
CrossSection cross_section(const SheetPicture& picture);

}  // namespace validate
