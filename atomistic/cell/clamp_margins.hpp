// Where a sheet that is free inside and held outside ends for a continuum: linear response of flat discs of atoms.
#pragma once

#include <string>

#include "atomistic/problem.hpp"

namespace atomistic {

/// In bonds. Displacements end `clamp` beyond the free atoms' area, √(N A_atom/π); the slope there is `slope` times the
/// curvature, as if it were held that much farther out.
struct ClampMargins {
  double clamp_bonds = 0, slope_bonds = 0;
};

/// Means over discs of 7 to 15 lattice constants. The lattice's force constants are central differences of the forces
/// about one atom of each sublattice; those of a disc are theirs between free atoms, since held atoms stay in the
/// lattice. Loaded by smooth outward forces near the axis, displacements outside are u = k/r − c r with
/// k = Σ r·f / (4π C11): they end at a² = k/c. Loaded out of the plane, the atoms are more compliant than a clamped
/// plate of the radius that has the mean margin by (Σ f (1 − r²/a²))² a²/4π / (2 a κ/h + 4 κ) with the slope's margin
/// h. Needs a0, C11 and the bending moduli of the card. Throws std::runtime_error where the flat sheet is not stable.
ClampMargins clamp_margins(const Potential& potential, const Card& card, const std::string& log_file);

}  // namespace atomistic
