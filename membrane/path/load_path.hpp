// Follows the levels of a problem on triangles, from the flat sheet.
#pragma once

#include "membrane/problem.hpp"

namespace membrane {

/// The problem is one that check() accepts, with Triangles.
Report follow_on_triangles(const Problem& problem, const OnStep& on_step);

}  // namespace membrane
