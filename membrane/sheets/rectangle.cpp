#include "membrane/sheets/rectangle.hpp"

#include <algorithm>
#include <cmath>

namespace membrane {
namespace {

/// Place of a grid line at t in [−1, 1] from the middle, as a share of the half length. Its density rises towards the
/// ends: the widest cell is `grading` times the narrowest.
double place(double t, double grading) {
  if (grading == 1) return t;
  const double s = std::log(grading);  // cell width ∝ exp(−s |t|)
  return std::copysign(std::expm1(-s * std::abs(t)) / std::expm1(-s), t);
}

/// Coordinates of the grid lines along one axis, Å. A quarter spans [0, L/2] exactly.
std::vector<double> lines(double length, int cells, const RectangleSheet& sheet) {
  std::vector<double> x(cells + 1);
  for (int i = 0; i <= cells; ++i) {
    const double t = sheet.extent == Extent::quarter ? double(i) / cells : 2.0 * i / cells - 1;
    x[i] = 0.5 * length * place(t, sheet.edge_grading);
  }
  return x;
}

bool has_clamped_edge(const RectangleSheet& sheet) {
  for (Support support : {sheet.left, sheet.right, sheet.bottom, sheet.top})
    if (support == Support::clamped) return true;
  return false;
}

/// Takes the freedom to move as a rigid body in the plane: the middle node, and that of the right edge across. Loads
/// that balance themselves leave these supports without force.
void pin(int middle, int middle_of_right_edge, Mesh& mesh) {
  mesh.held[middle][0] = mesh.held[middle][1] = true;
  mesh.held[middle_of_right_edge][1] = true;
}

}  // namespace

Mesh rectangle_mesh(const RectangleSheet& sheet) {
  const bool quarter = sheet.extent == Extent::quarter;
  const int nx = sheet.cells_x, ny = sheet.cells_y;
  const std::vector<double> x = lines(sheet.length_x_A, nx, sheet), y = lines(sheet.length_y_A, ny, sheet);
  Mesh mesh;
  mesh.copies = quarter ? 4 : 1;
  mesh.mirrored = {quarter, quarter};
  const auto node = [&](int i, int j) { return j * (nx + 1) + i; };
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i) {
      if (i == 0 && !quarter) mesh.edges[Edge::left].push_back(mesh.node_count());
      if (i == nx) mesh.edges[Edge::right].push_back(mesh.node_count());
      if (j == 0 && !quarter) mesh.edges[Edge::bottom].push_back(mesh.node_count());
      if (j == ny) mesh.edges[Edge::top].push_back(mesh.node_count());
      mesh.nodes.emplace_back(x[i], y[j]);
      mesh.held.push_back({quarter && i == 0, quarter && j == 0, false});
    }
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const int a = node(i, j), b = node(i + 1, j), c = node(i + 1, j + 1), d = node(i, j + 1);
      const bool rising = (x[i] + x[i + 1]) * (y[j] + y[j + 1]) >= 0;  // the diagonal towards the origin
      if (rising) {
        mesh.triangles.push_back(make_triangle(mesh.nodes, {a, b, c}));
        mesh.triangles.push_back(make_triangle(mesh.nodes, {a, c, d}));
      } else {
        mesh.triangles.push_back(make_triangle(mesh.nodes, {a, b, d}));
        mesh.triangles.push_back(make_triangle(mesh.nodes, {b, c, d}));
      }
    }
  if (!quarter && !has_clamped_edge(sheet)) pin(node(nx / 2, ny / 2), node(nx, ny / 2), mesh);
  return mesh;
}

Eigen::VectorXd interpolate(const RectangleSheet& coarse, const Eigen::VectorXd& u, const RectangleSheet& fine) {
  const auto node = [](const RectangleSheet& sheet, int i, int j) { return 3 * (j * (sheet.cells_x + 1) + i); };
  Eigen::VectorXd result(3 * (fine.cells_x + 1) * (fine.cells_y + 1));
  for (int j = 0; j <= fine.cells_y; ++j)
    for (int i = 0; i <= fine.cells_x; ++i) {
      const double x = double(i) * coarse.cells_x / fine.cells_x, y = double(j) * coarse.cells_y / fine.cells_y;
      const int left = std::min(int(x), coarse.cells_x - 1), below = std::min(int(y), coarse.cells_y - 1);
      const double s = x - left, t = y - below;
      const auto at = [&](int right, int up) { return u.segment<3>(node(coarse, left + right, below + up)); };
      result.segment<3>(node(fine, i, j)) =
          (1 - t) * ((1 - s) * at(0, 0) + s * at(1, 0)) + t * ((1 - s) * at(0, 1) + s * at(1, 1));
    }
  return result;
}

}  // namespace membrane
