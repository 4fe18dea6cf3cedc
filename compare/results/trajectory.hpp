// Where the atoms of a curve are at every depth.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace validate {

/// The first frame is the flat sheet as built, at depth and force 0. `positions_A`: frame by frame, atom by atom, x, y,
/// z.
struct AtomsTrajectory {
  std::string load;
  std::size_t atoms = 0, free_atoms = 0;  ///< the free ones come first
  std::vector<double> depth_A, force_eV_per_A;
  std::vector<float> positions_A;
};

}  // namespace validate
