// One quarter of a clamped disc between its two symmetry planes.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "membrane/mesh.hpp"

namespace membrane {

/// Ring i (from the centre) carries i + 1 nodes over the quarter, on the true circle at even angles, so that
/// it holds 2 i − 1 triangles and the whole rings² of them. Node 0 is the centre.
struct QuarterDisc {
  std::vector<double> radii_A;  ///< of the rings of nodes, radii_A[0] = 0
  Mesh mesh;  ///< x, y ≥ 0; planes x = 0 and y = 0 are symmetry planes, the rim is clamped
};

/// Mesh over rings of the given radii (rising from 0, Å). Throws std::invalid_argument where a ring is so
/// thin that its chords cross the ring inside.
QuarterDisc quarter_disc(const std::vector<double>& radii_A);

/// Weights over the nodes (length: node count, total 1) whose dot product with a nodal field is its mean over
/// the angle at radius r: on a ring of nodes exactly, between two rings linear in r.
Eigen::VectorXd mean_on_circle(const QuarterDisc& disc, double radius_A);

}  // namespace membrane
