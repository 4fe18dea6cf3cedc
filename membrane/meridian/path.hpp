// Follows the levels of a disc along its meridian, from the flat sheet.
#pragma once

#include "membrane/problem.hpp"

namespace membrane::meridian {

/// The problem is one that check() accepts, with Meridian.
Report follow(const Problem& problem, const OnStep& on_step);

}  // namespace membrane::meridian
