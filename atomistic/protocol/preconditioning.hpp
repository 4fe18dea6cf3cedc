// Which preconditioner a sheet gets: what both programs know.
#pragma once

#include "atomistic/problem.hpp"

namespace atomistic {

/// Whether the programs were built with a multigrid.
bool has_multigrid();

/// from here on a cycle costs less than the factor. Measured with Tersoff, whose forces are the cheapest, one depth
/// from the continuum's shape.
inline constexpr int multigrid_from_atoms = 100000;

/// The factor or the multigrid: what was asked for, and for Preconditioning::automatic by the number of free atoms.
Preconditioning preconditioning_for(Preconditioning asked, int free_atoms);

}  // namespace atomistic
