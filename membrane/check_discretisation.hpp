// What a discretisation can do of a problem that makes sense.
#pragma once

#include "membrane/problem.hpp"

namespace membrane {

/// Radii of the widest loads that a discretisation can solve, Å.
struct Widest {
  double patch_A = 0, sphere_A = 0;
};
Widest widest_load(const Problem& problem);

/// Throws std::invalid_argument naming the member and what else would do.
void check_discretisation(const Problem& problem);

}  // namespace membrane
