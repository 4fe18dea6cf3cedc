#include "compare/documents/plots/sheet_maps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace validate {
namespace {

bool is_quarter(const SheetPicture& picture) { return picture.mesh.copies > 1; }

double half_side(const SheetPicture& picture) {
  double size = 0;
  for (const auto& X : picture.mesh.nodes) size = std::max(size, X.lpNorm<Eigen::Infinity>());
  return size;
}

double flat_area(const SheetPicture& picture, const std::array<int, 3>& nodes) {
  const auto at = [&](int a) { return picture.mesh.nodes[static_cast<std::size_t>(nodes[a])]; };
  const Eigen::Vector2d u = at(1) - at(0), v = at(2) - at(0);
  return std::abs(u.x() * v.y() - u.y() * v.x()) / 2;
}

Panel stress_panel(const SheetPicture& picture, const std::string& title, const std::string& key) {
  Panel panel = seen_from_above(title, half_side(picture));
  panel.maps = {recovered_map(picture, title, key)};
  panel.scale.label = "eV/Å³";
  panel.scale.low = std::min(0.0, std::ranges::min(panel.maps[0].value));
  return panel;
}

Panel state_panel(const SheetPicture& picture) {
  Panel panel = seen_from_above("states and tension rays", half_side(picture));
  panel.maps = {triangle_map(picture, "state", "state")};
  panel.scale = scale_of_states();
  panel.curves = {tension_rays(picture, SeenOver::deformed)};
  return panel;
}

}  // namespace

Eigen::Vector2d place_of(const SheetPicture& picture, int node, SeenOver over) {
  const auto n = static_cast<std::size_t>(node);
  if (over == SeenOver::flat) return picture.mesh.nodes[n];
  return picture.mesh.nodes[n] + Eigen::Vector2d(picture.displacement[3 * n], picture.displacement[3 * n + 1]);
}

Eigen::Vector2d middle_of(const SheetPicture& picture, std::size_t triangle, SeenOver over) {
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const int node : picture.mesh.triangles[triangle].nodes) middle += place_of(picture, node, over) / 3;
  return middle;
}

TriangleMap triangle_map(const SheetPicture& picture, const std::string& name, const std::string& key, SeenOver over) {
  TriangleMap map{.name = name, .key = key, .corners = {}, .value = column(picture.triangles, key)};
  map.quarter = is_quarter(picture);
  for (const auto& triangle : picture.mesh.triangles) {
    const auto corner = [&](int a) { return place_of(picture, triangle.nodes[a], over); };
    map.corners.push_back({corner(0), corner(1), corner(2)});
  }
  return map;
}

std::vector<double> at_nodes(const SheetPicture& picture, const std::vector<double>& of_triangles) {
  std::vector<double> sum(picture.mesh.nodes.size(), 0), area(picture.mesh.nodes.size(), 0);
  for (std::size_t t = 0; t < of_triangles.size(); ++t) {
    const auto& nodes = picture.mesh.triangles[t].nodes;
    const double own = flat_area(picture, nodes);  // a picture that was read has none of its own
    for (const int node : nodes) {
      sum[static_cast<std::size_t>(node)] += own * of_triangles[t];
      area[static_cast<std::size_t>(node)] += own;
    }
  }
  for (std::size_t n = 0; n < sum.size(); ++n) sum[n] /= area[n];
  return sum;
}

TriangleMap recovered_map(const SheetPicture& picture, const std::string& name, const std::string& key, SeenOver over) {
  TriangleMap map = triangle_map(picture, name, key, over);
  const std::vector<double> nodal = at_nodes(picture, map.value);
  for (const auto& triangle : picture.mesh.triangles) {
    const auto value = [&](int a) { return nodal[static_cast<std::size_t>(triangle.nodes[a])]; };
    map.at_corners.push_back({value(0), value(1), value(2)});
  }
  return map;
}

void raise(TriangleMap& map, const SheetPicture& picture) {
  for (const auto& triangle : picture.mesh.triangles) {
    const auto z = [&](int a) { return picture.displacement[3 * static_cast<std::size_t>(triangle.nodes[a]) + 2]; };
    map.height.push_back({z(0), z(1), z(2)});
  }
}

PlotCurve tension_rays(const SheetPicture& picture, SeenOver over) {
  constexpr int across = 14;
  const auto& state = column(picture.triangles, "state");
  const auto& direction = column(picture.triangles, "direction");
  const double spacing = half_side(picture) / across;
  PlotCurve curve{.name = "tension rays", .x = {}, .y = {}, .line = Line{.width = 0.6}, .strokes = true};
  std::set<std::pair<int, int>> taken;
  for (std::size_t t = 0; t < state.size(); ++t) {
    if (state[t] != 1) continue;
    const Eigen::Vector2d flat = middle_of(picture, t, SeenOver::flat), centre = middle_of(picture, t, over);
    if (!taken.insert({int(std::floor(flat.x() / spacing)), int(std::floor(flat.y() / spacing))}).second) continue;
    const Eigen::Vector2d half = 0.4 * spacing * Eigen::Vector2d(direction[3 * t], direction[3 * t + 1]);
    for (const int sx : {1, -1})
      for (const int sy : {1, -1}) {
        if (!is_quarter(picture) && (sx < 0 || sy < 0)) continue;
        for (const Eigen::Vector2d& end : {Eigen::Vector2d(centre - half), Eigen::Vector2d(centre + half)}) {
          curve.x.push_back(sx * end.x());
          curve.y.push_back(sy * end.y());
        }
      }
  }
  return curve;
}

Panel seen_from_above(const std::string& title, double half_side_A) {
  const double end = 1.02 * half_side_A;
  return {.title = title,
          .x = {.label = "x", .unit = "Å", .key = "x_A", .low = -end, .high = end},
          .y = {.label = "y", .unit = "Å", .key = "y_A", .low = -end, .high = end},
          .equal_axes = true};
}

ColourScale scale_of_states() {
  return {.classes = {{"taut", Colour::sky}, {"wrinkled", Colour::orange}, {"slack", Colour::pale_grey}}};
}

Plot sheet_plot(const SheetPicture& picture) {
  return {
      .panels = {stress_panel(picture, "larger principal Cauchy stress", "cauchy_1_eV_per_A3"),
                 stress_panel(picture, "smaller principal Cauchy stress", "cauchy_2_eV_per_A3"), state_panel(picture)},
      .columns = 3,
      .width = 3 * 480,
      .height = 400};
}

}  // namespace validate
