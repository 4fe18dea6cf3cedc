#include "compare/figures/square.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "compare/base/paper.hpp"
#include "compare/documents/plots/sheet_maps.hpp"

namespace validate {
namespace {

constexpr double half_side_A = paper::side_A / 2;

}  // namespace

std::vector<SheetPicture> solved_levels(const membrane::Problem& problem, double thickness_A, const char* figure) {
  SheetAlbum album(problem, thickness_A, true);
  const membrane::Report report = membrane::solve(problem, [&](const membrane::Step& step) {
    album.keep(step);
    return step.converged;
  });
  if (!report.converged) throw std::runtime_error(std::string(figure) + ": " + report.reason);
  return album.pictures();
}

double largest_pull_in_A(const SheetPicture& square) {
  double largest = 0;
  for (const auto& [edge, nodes] : square.mesh.edges)
    for (const int n : nodes) {
      const int across = edge == membrane::Edge::left || edge == membrane::Edge::right ? 0 : 1;
      const double place = square.mesh.nodes[static_cast<std::size_t>(n)][across];
      largest =
          std::max(largest, -square.displacement[static_cast<std::size_t>(3 * n + across)] * (place > 0 ? 1 : -1));
    }
  return largest;
}

PlotCurve wrinkled_outline(const SheetPicture& square, SeenOver over) {
  PlotCurve curve{.name = "wrinkled zone", .x = {}, .y = {}, .colour = Colour::white};
  curve.line = Line{.width = 1};
  curve.strokes = true;
  std::vector<double> wrinkled = column(square.triangles, "state");
  for (double& state : wrinkled) state = state == 1;
  const std::vector<double> share = at_nodes(square, wrinkled);
  for (const auto& triangle : square.mesh.triangles)
    for (int a = 0; a < 3; ++a) {
      const int here = triangle.nodes[a], next = triangle.nodes[(a + 1) % 3];
      const double s = share[static_cast<std::size_t>(here)], e = share[static_cast<std::size_t>(next)];
      if ((s < 0.5) == (e < 0.5)) continue;
      const Eigen::Vector2d place = place_of(square, here, over) +
                                    (0.5 - s) / (e - s) * (place_of(square, next, over) - place_of(square, here, over));
      curve.x.push_back(place.x());
      curve.y.push_back(place.y());
    }
  return curve;
}

Panel square_panel(const std::string& title, const char* label) {
  Panel panel = seen_from_above(title, paper::side_A / 2);
  panel.scale.label = label;
  return panel;
}

Panel square_panel(const std::string& title, const char* label, const SheetPicture& square, const std::string& column,
                   const std::string& key) {
  Panel panel = square_panel(title, label);
  panel.maps = {column == "state" ? triangle_map(square, title, column) : recovered_map(square, title, column)};
  panel.maps[0].key = key;
  panel.curves = {wrinkled_outline(square, SeenOver::deformed)};
  return panel;
}

}  // namespace validate
