#include "membrane/sheets/mesh.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <sstream>
#include <stdexcept>

namespace membrane {
namespace {

void add_ring(const NodeRing& ring, double share, Eigen::VectorXd& weights) {
  if (ring.closed || ring.count == 1) {
    weights.segment(ring.first, ring.count).array() += share / ring.count;
    return;
  }
  weights.segment(ring.first, ring.count).array() += share / (ring.count - 1);
  for (int end : {ring.first, ring.first + ring.count - 1})  // on the symmetry planes: half
    weights[end] -= 0.5 * share / (ring.count - 1);
}

int nearest_to_origin(const Mesh& mesh) {
  const auto nearest = std::min_element(mesh.nodes.begin(), mesh.nodes.end(),
                                        [](const auto& a, const auto& b) { return a.squaredNorm() < b.squaredNorm(); });
  return static_cast<int>(std::distance(mesh.nodes.begin(), nearest));
}

}  // namespace

double Mesh::area_A2() const {
  double area = 0;
  for (const Triangle& triangle : triangles) area += triangle.area_A2;
  return area;
}

void Mesh::support(Edge edge, Support support) {
  supports[edge] = support;
  for (int node : edges.at(edge)) {
    if (support == Support::clamped) held[node] = {true, true, true};
    if (support == Support::sliding) held[node][2] = true;
  }
}

bool Mesh::slides(Edge edge) const {
  const auto found = supports.find(edge);
  return found != supports.end() && found->second == Support::sliding;
}

/// A side is on the boundary where one triangle alone has it.
std::vector<std::array<int, 2>> sliding_sides(const Mesh& mesh) {
  std::set<int> sliding;
  for (const auto& [edge, members] : mesh.edges)
    if (mesh.slides(edge)) sliding.insert(members.begin(), members.end());
  std::set<std::array<int, 2>> sides;
  for (const Triangle& triangle : mesh.triangles)
    for (int i = 0; i < 3; ++i) {
      const int start = triangle.nodes[i], end = triangle.nodes[(i + 1) % 3];
      if (!sliding.contains(start) || !sliding.contains(end)) continue;
      if (sides.erase({end, start}) == 0) sides.insert({start, end});
    }
  return {sides.begin(), sides.end()};
}

Triangle make_triangle(const std::vector<Eigen::Vector2d>& nodes, const std::array<int, 3>& corners) {
  const auto& [a, b, c] = corners;
  const Eigen::Vector2d ab = nodes[b] - nodes[a];
  const Eigen::Vector2d bc = nodes[c] - nodes[b];
  const Eigen::Vector2d ca = nodes[a] - nodes[c];
  const double twice_area = ab.x() * bc.y() - ab.y() * bc.x();
  if (!(twice_area > 0)) {
    std::ostringstream message;
    message << "triangle of nodes " << a << ", " << b << ", " << c << " has area " << 0.5 * twice_area
            << " Å²: must be positive (corners counter-clockwise)";
    throw std::invalid_argument(message.str());
  }
  Triangle triangle{corners, 0.5 * twice_area, {}};
  triangle.shape_gradients << -bc.y(), -ca.y(), -ab.y(), bc.x(), ca.x(), ab.x();
  triangle.shape_gradients /= twice_area;
  return triangle;
}

Eigen::VectorXd mean_on_circle(const Mesh& mesh, double radius_A) {
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(mesh.node_count());
  if (mesh.rings.empty() || radius_A == 0) {
    weights[nearest_to_origin(mesh)] = 1;
    return weights;
  }
  const auto above = std::lower_bound(mesh.rings.begin(), mesh.rings.end() - 1, radius_A,
                                      [](const NodeRing& ring, double r) { return ring.radius_A < r; });
  if (above == mesh.rings.begin() || above->radius_A == radius_A) {
    add_ring(*above, 1, weights);
    return weights;
  }
  const auto below = above - 1;
  const double share = (radius_A - below->radius_A) / (above->radius_A - below->radius_A);
  add_ring(*below, 1 - share, weights);
  add_ring(*above, share, weights);
  return weights;
}

}  // namespace membrane
