// Round sheets as rings of nodes: discs and annuli.
#pragma once

#include <vector>

#include "membrane/sheets/sheet.hpp"

namespace membrane {

/// Disc over rings of the given radii (rising from 0, Å): one sector of a quarter turn between its symmetry planes, or
/// six sectors of a full one. In each sector ring i has i segments, so that it holds 2 i − 1 triangles and the sector
/// rings². Node 0 is the centre. Throws std::invalid_argument where a ring is so thin that its chords cross the ring
/// inside.
Mesh disc_mesh(const std::vector<double>& radii_A, Extent extent);

/// Annulus of equal rings of quadrilaterals, cut along diagonals that alternate.
Mesh annulus_mesh(double hub_radius_A, double radius_A, int rings, int around);

}  // namespace membrane
