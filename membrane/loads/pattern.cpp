#include "membrane/loads/pattern.hpp"

#include <algorithm>
#include <stdexcept>

#include "membrane/refusal.hpp"

namespace membrane {
namespace {

struct PatternOf {
  const Mesh& mesh;
  Pattern operator()(const PointLoad&) const { return point_pattern(mesh, 0); }
  Pattern operator()(const DiscLoad& disc) const { return disc_pattern(mesh, disc.radius_A); }
};

}  // namespace

Eigen::VectorXd Pattern::direction() const {
  Eigen::VectorXd direction = Eigen::VectorXd::Zero(3 * weights.size());
  for (Eigen::Index n = 0; n < weights.size(); ++n) direction[3 * n + 2] = -weights[n];
  return direction;
}

Pattern point_pattern(const Mesh& mesh, int node) {
  if (node < 0 || node >= mesh.node_count()) throw std::out_of_range("point_pattern: no such node");
  Pattern pattern{Eigen::VectorXd::Zero(mesh.node_count())};
  pattern.weights[node] = 1;
  return pattern;
}

Pattern disc_pattern(const Mesh& mesh, double radius_A) {
  const double reach = radius_A * (1 + 1e-9);  // the nodes of the edge are on it to rounding
  const auto inside = [&](int node) { return mesh.nodes[node].norm() <= reach; };
  Pattern pattern{Eigen::VectorXd::Zero(mesh.node_count())};
  for (const Triangle& triangle : mesh.triangles)
    if (std::all_of(triangle.nodes.begin(), triangle.nodes.end(), inside))
      for (int node : triangle.nodes) pattern.weights[node] += triangle.area_A2 / 3;
  const double area = pattern.weights.sum();
  if (!(area > 0)) refuse("load.radius_A", radius_A, "no triangle of the sheet lies within it");
  pattern.weights /= area;
  return pattern;
}

Pattern make_pattern(const Load& load, const Mesh& mesh) { return std::visit(PatternOf{mesh}, load); }

}  // namespace membrane
