// What a continuum expects, for the atoms to start from.
#pragma once

#include <vector>

#include "atomistic/problem.hpp"
#include "membrane/problem.hpp"

namespace validate {

/// The shapes of a continuum on a meridian at its levels, as far as it goes.
std::vector<atomistic::Guide> guides_from(const membrane::Problem& problem);

}  // namespace validate
