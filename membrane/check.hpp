// Refuses problems that make no sense.
#pragma once

#include "membrane/problem.hpp"

namespace membrane {

/// Throws std::invalid_argument naming the member, its value and what is allowed.
void check(const Problem& problem);

}  // namespace membrane
