// Squares under pressure whose edges slide in their plane: the airbag and the paper's figure 4.
#pragma once

#include "membrane/problem.hpp"

namespace validate::verify {

/// Principal Cauchy stress × thickness, least and largest over the triangles (eV/Å²), of the smaller
/// principal value.
struct SmallerStress {
  double least = 0, largest = 0;
};

SmallerStress smaller_cauchy_force(const membrane::Problem& problem, const membrane::Step& step);

}  // namespace validate::verify
