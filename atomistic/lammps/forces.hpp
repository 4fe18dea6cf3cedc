// Energy and forces of given positions, as LAMMPS says them.
#pragma once

#include <string>
#include <vector>

#include "atomistic/lammps/lammps.hpp"
#include "atomistic/response.hpp"

namespace atomistic {

/// Of an isolated set of atoms at each of the positions (3N, all of one size), one after the other in one instance. All
/// ranks call it; rank 0 gets the answer. Throws std::invalid_argument for no positions or sizes that differ.
std::vector<AtomForces> compute_forces(const Potential& potential, const std::vector<Eigen::VectorXd>& positions,
                                       const std::string& log_file, const MpiSession& session);

}  // namespace atomistic
