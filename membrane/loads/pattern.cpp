#include "membrane/loads/pattern.hpp"

#include <algorithm>
#include <stdexcept>

#include "membrane/base/refusal.hpp"

namespace membrane {

Eigen::VectorXd Pattern::direction() const {
  Eigen::VectorXd direction = Eigen::VectorXd::Zero(3 * weights.size());
  for (Eigen::Index n = 0; n < weights.size(); ++n) direction[3 * n + 2] = -weights[n];
  return direction;
}

Pattern Pattern::padded(Eigen::Index nodes) const {
  Pattern all{Eigen::VectorXd::Zero(nodes)};
  all.weights.head(weights.size()) = weights;
  return all;
}

Pattern point_pattern(int nodes, int node) {
  if (node < 0 || node >= nodes) throw std::out_of_range("point_pattern: no such node");
  Pattern pattern{Eigen::VectorXd::Zero(nodes)};
  pattern.weights[node] = 1;
  return pattern;
}

Pattern radial_pattern(const Mesh& mesh, double radius_A, const std::function<double(double)>& density) {
  const double reach = radius_A * (1 + 1e-9);  // the nodes of the edge are on it to rounding
  const auto inside = [&](int node) { return mesh.nodes[node].norm() <= reach; };
  Pattern pattern{Eigen::VectorXd::Zero(mesh.node_count())};
  for (const Triangle& triangle : mesh.triangles) {
    const auto& nodes = triangle.nodes;
    if (!std::all_of(nodes.begin(), nodes.end(), inside)) continue;
    for (int side = 0; side < 3; ++side) {  // both ends of a side have shape function ½ in its middle
      const int a = nodes[side], b = nodes[(side + 1) % 3];
      const double radius = 0.5 * (mesh.nodes[a] + mesh.nodes[b]).norm();
      const double share = triangle.area_A2 / 6 * density(radius);
      pattern.weights[a] += share;
      pattern.weights[b] += share;
    }
  }
  const double total = pattern.weights.sum();
  if (!(total > 0)) refuse("load.radius_A", radius_A, "no loaded triangle of the sheet lies within it");
  pattern.weights /= total;
  return pattern;
}

}  // namespace membrane
