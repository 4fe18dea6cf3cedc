#include "membrane/quarter_disc.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace membrane {
namespace {

int node_at(int ring, int position) { return ring * (ring + 1) / 2 + position; }

void add_nodes(int ring, double radius, bool rim, Mesh& mesh) {
  for (int position = 0; position <= ring; ++position) {
    const bool on_x_axis = position == 0;  // there y stays 0
    const bool on_y_axis = position == ring;
    const double angle = ring == 0 ? 0 : 0.5 * std::numbers::pi * position / ring;
    mesh.nodes.emplace_back(on_y_axis ? 0 : radius * std::cos(angle),
                            on_x_axis ? 0 : radius * std::sin(angle));
    mesh.held.push_back({rim || on_y_axis, rim || on_x_axis, rim});
  }
}

void add_triangles(int ring, bool rim, Mesh& mesh) {
  for (int position = 0; position < ring; ++position) {
    const int inner = node_at(ring - 1, position);
    const int outer = node_at(ring, position);
    if (rim) mesh.rim_triangles.push_back(static_cast<int>(mesh.triangles.size()));
    mesh.triangles.push_back(make_triangle(mesh.nodes, {inner, outer, outer + 1}));
    if (position + 1 < ring)
      mesh.triangles.push_back(make_triangle(mesh.nodes, {inner, outer + 1, inner + 1}));
  }
}

}  // namespace

QuarterDisc quarter_disc(const std::vector<double>& radii_A) {
  QuarterDisc disc{radii_A, {}};
  disc.mesh.copies = 4;
  const int rings = static_cast<int>(radii_A.size()) - 1;
  for (int ring = 0; ring <= rings; ++ring) {
    add_nodes(ring, radii_A[ring], ring == rings, disc.mesh);
    if (ring > 0) add_triangles(ring, ring == rings, disc.mesh);
  }
  return disc;
}

Eigen::VectorXd mean_on_circle(const QuarterDisc& disc, double radius_A) {
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(disc.mesh.node_count());
  const auto add_ring = [&](int ring, double share) {
    if (ring == 0) {
      weights[0] += share;
      return;
    }
    for (int position = 0; position <= ring; ++position)  // nodes on the symmetry planes count half
      weights[node_at(ring, position)] += share * (position % ring == 0 ? 0.5 : 1.0) / ring;
  };
  const auto& radii = disc.radii_A;
  const auto above = std::lower_bound(radii.begin(), radii.end(), radius_A);
  const int outer = static_cast<int>(std::min(above, radii.end() - 1) - radii.begin());
  if (outer == 0 || radii[outer] == radius_A) {
    add_ring(outer, 1);
  } else {
    const double share = (radius_A - radii[outer - 1]) / (radii[outer] - radii[outer - 1]);
    add_ring(outer - 1, 1 - share);
    add_ring(outer, share);
  }
  return weights;
}

}  // namespace membrane
