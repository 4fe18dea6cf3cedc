// A triangulated flat sheet with its boundary: what assembly and loads need to know of a shape.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "membrane/kinematics.hpp"

namespace membrane {

/// Nodes in the plane z = 0 and triangles over them. Degree of freedom 3 n + c is component c of node n.
struct Mesh {
  std::vector<Eigen::Vector2d> nodes;     ///< Å
  std::vector<Triangle> triangles;        ///< counter-clockwise
  std::vector<std::array<bool, 3>> held;  ///< per node and component: displacement stays zero
  std::vector<int> rim_triangles;         ///< triangles with an edge on the clamped rim
  int copies = 1;                         ///< the full sheet consists of this many of the meshed part

  int node_count() const { return static_cast<int>(nodes.size()); }
  int dof_count() const { return 3 * node_count(); }
};

/// Triangle over three nodes of the plane. Throws std::invalid_argument if it is degenerate or turned over.
Triangle make_triangle(const std::vector<Eigen::Vector2d>& nodes, const std::array<int, 3>& corners);

}  // namespace membrane
