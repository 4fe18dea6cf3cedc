// A load as a pattern: non-negative weights on the nodes with unit total, acting along −z.
#pragma once

#include <Eigen/Core>
#include <functional>

#include "membrane/sheets/mesh.hpp"

namespace membrane {

/// Weights p over the nodes, p ≥ 0, Σ p = 1. A force F puts −F p_i on node i along z; its work-conjugate
/// depth is d = Σ p_i (−z_i).
struct Pattern {
  Eigen::VectorXd weights;

  /// dd/du over all degrees of freedom: −p_i at the z components, 0 elsewhere.
  Eigen::VectorXd direction() const;

  /// The same over more nodes, which bear nothing.
  Pattern padded(Eigen::Index nodes) const;
};

/// The whole force on one node of `nodes`. Throws std::out_of_range for a node that is not there.
Pattern point_pattern(int nodes, int node);

/// Density (per reference area, over the radius in Å) on the triangles within radius_A of the origin, whose edge must
/// lie on element edges, by the triangles' mid-side rule (exact for a linear density). The total is one whatever area
/// the chords cut off. Throws std::invalid_argument if none lies inside.
Pattern radial_pattern(const Mesh& mesh, double radius_A, const std::function<double(double)>& density);

}  // namespace membrane
