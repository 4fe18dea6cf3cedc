// A first guess from the same problem on a coarser mesh.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "membrane/problem.hpp"

namespace membrane {

/// Displacements of a rectangle at one value of its load, solved with half the cells each way and
/// interpolated; the coarse problem begins the same way. Nothing where the mesh has no more than `coarsest`
/// cells along an edge, cannot be halved, or did not converge. A sheet whose edges slide has many states of
/// almost the same energy; coarse ones find the deep tucks that a fine one misses, and hand them on. Slack
/// zones, which have no stiffness to guide Newton's method, are found while there are few nodes in them.
std::optional<Eigen::VectorXd> guess_from_coarser(const Problem& problem, double value, int coarsest);

}  // namespace membrane
