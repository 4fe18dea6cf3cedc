// Smooth displacements out of the plane, to start a search for an equilibrium from another place.
#pragma once

#include <Eigen/Core>

#include "atomistic/lattice/sheet.hpp"

namespace atomistic {

/// Displacements of the free atoms (3·free_atoms, along z only): waves of random direction, phase and length (10 … 60
/// Å) with this root mean square over the sheet, falling to zero within 8 Å of the edge. The same seed gives the same
/// ripple.
Eigen::VectorXd ripple(const Sheet& sheet, double rms_A, unsigned seed);

/// Waves around the axis of a disc, of this amplitude at four fifths of the radius and none at the rim: what a sheet
/// wrinkles by when its rim is drawn in.
Eigen::VectorXd ripple_around(const Sheet& sheet, double amplitude_A, int waves_around);

}  // namespace atomistic
