// A sheet as a LAMMPS data file, for runs of LAMMPS alone.
#pragma once

#include <Eigen/Core>
#include <string>

#include "atomistic/problem.hpp"

namespace atomistic {

/// The text that `read_data` takes with `atom_style atomic`: one atom type, ids 1 … N in the order of the positions
/// (3N, Å) with all their digits, a box with 5 Å around the atoms.
std::string data_file(const Potential& potential, const Eigen::VectorXd& positions);

}  // namespace atomistic
