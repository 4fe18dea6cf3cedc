// What a temperature does to the levels of a path, in first order of the vibrations' free energy.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "atomistic/lammps/lammps.hpp"
#include "atomistic/problem.hpp"
#include "atomistic/temperature.hpp"

namespace atomistic {

/// At each step, an equilibrium at T = 0 under the load's force F and conjugate depth d, with Φ the free energy of the
/// vibrations about it:
///   held force: G = E − F d + Φ(F),  mean depth = −dG/dF = d − dΦ/dF;
///   held depth: A = E + Φ_d(d),      mean force = F + dΦ_d/dd, Φ_d of the vibrations that leave the depth as it is.
/// The derivatives are central differences between two sheets moved along the linear response to the load: the path's
/// own curvature changes both alike. A sphere has its place in place of the force.
///
/// With more than one MPI rank every rank calls this; only rank 0 calls back. `done` levels are left out. Throws
/// std::invalid_argument for a sheet whose edge slides.
void heat_levels(const Problem& problem, const std::vector<Step>& steps, const Heat& heat, const std::string& log_file,
                 const std::vector<int>& done, const std::function<void(const HeatedLevel&)>& on_level,
                 const MpiSession& session);

}  // namespace atomistic
