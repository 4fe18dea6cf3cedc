// Where the nodes of a meridian go.
#pragma once

#include <vector>

#include "membrane/problem.hpp"

namespace membrane::meridian {

/// A stretch of the meridian that wants elements of this length; away from it they may grow.
struct Focus {
  double from_A = 0;
  double to_A = 0;
  double size_A = 0;
};

/// Radii 0 = r_0 < … < sheet radius, with a node at every one of `fixed` (ascending, inside). Lengths follow
/// min(largest, size + growth × distance) over the foci.
std::vector<double> graded_radii(double sheet_radius_A, const std::vector<double>& fixed,
                                 const std::vector<Focus>& foci, double growth, double largest_A);

/// The nodes that a problem on a meridian needs: short elements at the tip and at the load's edge; and, where the sheet
/// resists bending, some times the shortest boundary layer √(κ/N) long at that edge and at the rim.
std::vector<double> nodes_for(const Problem& problem);

}  // namespace membrane::meridian
