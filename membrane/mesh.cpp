#include "membrane/mesh.hpp"

#include <Eigen/Geometry>
#include <sstream>
#include <stdexcept>

namespace membrane {

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

}  // namespace membrane
