// Rectangular sheets as a grid of cells, each cut into two triangles.
#pragma once

#include "membrane/sheets/sheet.hpp"

namespace membrane {

/// The cells are cut so that the pattern is its own mirror image in both axes, as the sheet is: diagonals point towards
/// the origin. Held so far are the symmetry planes of a quarter only, not the edges, and
/// what keeps a full sheet without a clamped edge in its place.
Mesh rectangle_mesh(const RectangleSheet& sheet);

/// Displacements (three a node) of a coarser mesh of the same sheet on the nodes of a finer one, linear between grid
/// lines.
Eigen::VectorXd interpolate(const RectangleSheet& coarse, const Eigen::VectorXd& u, const RectangleSheet& fine);

}  // namespace membrane
