#include "compare/figures/square.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "compare/base/paper.hpp"
#include "compare/documents/plots/sheet_maps.hpp"

namespace validate {
namespace {

/// How far the middle of an edge has moved inwards, at most.
double pull_in(const membrane::Mesh& mesh, const Eigen::VectorXd& u) {
  double largest = 0;
  for (const auto& [edge, nodes] : mesh.edges)
    for (const int n : nodes) {
      const Eigen::Vector2d place = mesh.nodes[static_cast<std::size_t>(n)];
      const int across = edge == membrane::Edge::left || edge == membrane::Edge::right ? 0 : 1;
      largest = std::max(largest, -u[3 * n + across] * (place[across] > 0 ? 1 : -1));
    }
  return largest;
}

double wrinkled_share(const membrane::Mesh& mesh, const std::vector<TriangleStress>& field) {
  double wrinkled = 0, all = 0;
  for (std::size_t i = 0; i < field.size(); ++i) {
    all += mesh.triangles[i].area_A2;
    if (field[i].state == membrane::SheetState::wrinkled) wrinkled += mesh.triangles[i].area_A2;
  }
  return wrinkled / all;
}

}  // namespace

Square solve_square(const membrane::Problem& problem, double thickness_A) {
  Square square;
  square.mesh = membrane::mesh_of(problem);
  const membrane::Report report = membrane::solve(problem, [&](const membrane::Step& step) {
    if (!step.converged) return false;
    square.field = stress_field(problem, square.mesh, thickness_A, step.on_triangles().displacements);
    square.displacements_A = step.on_triangles().displacements;
    square.centre_depth_A = step.depth_A;
    square.volume_A3 = step.volume_A3;
    square.energy_eV = step.energy_eV;
    square.pull_in_A = pull_in(square.mesh, step.on_triangles().displacements);
    return true;
  });
  if (!report.converged) throw std::runtime_error("figure 4: " + report.reason);
  square.wrinkled_share = wrinkled_share(square.mesh, square.field);
  return square;
}

PlotCurve wrinkled_outline(const Square& square) {
  PlotCurve curve{.name = "wrinkled zone", .x = {}, .y = {}, .colour = Colour::white};
  curve.line = Line{.width = 1};
  curve.strokes = true;
  std::map<std::pair<int, int>, int> wrinkled_sides;  // how many wrinkled triangles a side has
  for (std::size_t i = 0; i < square.field.size(); ++i) {
    if (square.field[i].state != membrane::SheetState::wrinkled) continue;
    const auto& n = square.mesh.triangles[i].nodes;
    for (int a = 0; a < 3; ++a)
      ++wrinkled_sides[std::pair(std::min(n[a], n[(a + 1) % 3]), std::max(n[a], n[(a + 1) % 3]))];
  }
  for (const auto& [side, count] : wrinkled_sides) {
    if (count != 1) continue;
    for (const int node : {side.first, side.second}) {
      curve.x.push_back(square.mesh.nodes[static_cast<std::size_t>(node)][0]);
      curve.y.push_back(square.mesh.nodes[static_cast<std::size_t>(node)][1]);
    }
  }
  return curve;
}

Panel square_panel(const std::string& title, const char* label) {
  Panel panel = seen_from_above(title, paper::side_A / 2);
  panel.scale.label = label;
  return panel;
}

Panel square_panel(const std::string& title, const char* label, const char* key, const Square& square,
                   double (*value)(const TriangleStress&)) {
  Panel p = square_panel(title, label);
  TriangleMap map{.name = title, .key = key, .corners = {}, .value = {}};
  for (const TriangleStress& t : square.field) {
    map.corners.push_back(t.corners_A);
    map.value.push_back(value(t));
  }
  p.maps.push_back(std::move(map));
  p.curves.push_back(wrinkled_outline(square));
  return p;
}

}  // namespace validate
