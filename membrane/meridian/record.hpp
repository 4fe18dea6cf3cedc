// What is reported of an equilibrium.
#pragma once

#include <Eigen/Core>

#include "membrane/meridian/assembly.hpp"
#include "membrane/problem.hpp"

namespace membrane::meridian {

/// Shape, energies, strains, forces, volume and reactions of x; what belongs to the path is left for it to fill in.
/// The energy is counted from that of the flat sheet under its rim's tension.
Step record(const Problem& problem, Assembly& assembly, const Eigen::VectorXd& x, double flat_energy_eV = 0);

}  // namespace membrane::meridian
