#include "compare/documents/plots/field_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "compare/documents/plots/figure.hpp"
#include "compare/documents/plots/gnuplot.hpp"

namespace validate {
namespace {

constexpr int panel_width = 430, panel_height = 380;

using Text = std::back_insert_iterator<std::string>;

/// The mirror images that make the full sheet of a quarter: signs of x and y.
std::vector<std::array<int, 2>> images(const SheetPicture& picture) {
  if (picture.mesh.copies == 1) return {{1, 1}};
  return {{1, 1}, {-1, 1}, {1, -1}, {-1, -1}};
}

Eigen::Vector2d deformed(const SheetPicture& picture, int node) {
  return picture.mesh.nodes[node] + Eigen::Vector2d(picture.displacement[3 * node], picture.displacement[3 * node + 1]);
}

/// Each triangle as a quadrilateral with two equal corners, which is what gnuplot's pm3d fills.
void triangle_block(Text out, const SheetPicture& picture, const std::vector<double>& values) {
  for (const auto& [sx, sy] : images(picture))
    for (std::size_t t = 0; t < picture.mesh.triangles.size(); ++t) {
      const auto& nodes = picture.mesh.triangles[t].nodes;
      const auto corner = [&](int a) {
        const Eigen::Vector2d x = deformed(picture, nodes[a]);
        fmt::format_to(out, "{:.5g} {:.5g} {:.6g}\n", sx * x.x(), sy * x.y(), values[t]);
      };
      corner(0), corner(1);
      fmt::format_to(out, "\n");
      corner(2), corner(2);
      fmt::format_to(out, "\n\n");
    }
}

/// Tension rays of wrinkled triangles, thinned out to about this many a direction.
void ray_block(Text out, const SheetPicture& picture) {
  constexpr int across = 14;
  const auto& state = column(picture.triangles, "state");
  const auto& direction = column(picture.triangles, "direction");
  double size = 0;
  for (const auto& X : picture.mesh.nodes) size = std::max(size, X.lpNorm<Eigen::Infinity>());
  const double spacing = size / across;
  std::map<std::pair<int, int>, bool> taken;
  for (std::size_t t = 0; t < state.size(); ++t) {
    if (state[t] != 1) continue;
    Eigen::Vector2d centre = Eigen::Vector2d::Zero(), flat = Eigen::Vector2d::Zero();
    for (int node : picture.mesh.triangles[t].nodes) {
      centre += deformed(picture, node) / 3;
      flat += picture.mesh.nodes[node] / 3;
    }
    if (std::exchange(taken[{int(std::floor(flat.x() / spacing)), int(std::floor(flat.y() / spacing))}], true))
      continue;
    const Eigen::Vector2d half = 0.4 * spacing * Eigen::Vector2d(direction[3 * t], direction[3 * t + 1]);
    for (const auto& [sx, sy] : images(picture))
      fmt::format_to(out, "{:.5g} {:.5g} 0\n{:.5g} {:.5g} 0\n\n\n", sx * (centre - half).x(), sy * (centre - half).y(),
                     sx * (centre + half).x(), sy * (centre + half).y());
  }
}

void state_palette(Text out) {
  fmt::format_to(
      out,
      "set palette defined (0 '#4477AA', 0.99 '#4477AA', 1 '#EECC66', 1.5 '#EECC66', 1.51 '#BBBBBB', 2 '#BBBBBB')\n"
      "set cbrange [-0.5:2.5]\nset cbtics ('taut' 0, 'wrinkled' 1, 'slack' 2)\n");
}

void stress_palette(Text out, const FieldPanel& panel, const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  fmt::format_to(out,
                 "set palette defined (0 '#440154', 1 '#3b528b', 2 '#21918c', 3 '#5ec962', 4 '#fde725')\nset cbrange "
                 "[{:.6g}:{:.6g}]\nset cbtics auto format '%.3g'\n",
                 panel.low.value_or(std::min(*low, 0.0)), panel.high.value_or(*high > *low ? *high : *low + 1));
}

/// A square window about the sheet, and its place among the panels.
void place(Text out, const SheetPicture& picture, std::size_t index, std::size_t count) {
  double size = 0;
  for (const auto& X : picture.mesh.nodes) size = std::max(size, X.lpNorm<Eigen::Infinity>());
  const double step = std::pow(10, std::floor(std::log10(size)));
  fmt::format_to(out,
                 "set xrange [{0:.6g}:{1:.6g}]\nset yrange [{0:.6g}:{1:.6g}]\nset xtics {2:g}\nset ytics {2:g}\n"
                 "set lmargin at screen {3:.4f}\nset rmargin at screen {4:.4f}\nset bmargin at screen 0.16\n"
                 "set tmargin at screen 0.88\n",
                 -1.02 * size, 1.02 * size, size / step < 3 ? step : 2 * step, (index + 0.13) / count,
                 (index + 0.72) / count);
}

void panel_commands(Text out, const FieldPanel& panel, std::size_t index, std::size_t count) {
  const bool is_state = panel.key == "state";
  const auto& values = column(panel.picture->triangles, panel.key);
  place(out, *panel.picture, index, count);
  fmt::format_to(out, "$field{} << EOD\n", index);
  triangle_block(out, *panel.picture, values);
  fmt::format_to(out, "EOD\nset title {}\n", gnuplot_quoted(panel.title));
  if (is_state) {
    fmt::format_to(out, "$rays{} << EOD\n", index);
    ray_block(out, *panel.picture);
    fmt::format_to(out, "EOD\n");
    state_palette(out);
  } else {
    stress_palette(out, panel, values);
  }
  fmt::format_to(out, "splot $field{0} using 1:2:(0):3 with pm3d notitle", index);
  if (is_state) fmt::format_to(out, ", $rays{0} using 1:2:3 with lines lw 0.6 lc rgb 'black' notitle", index);
  fmt::format_to(out, "\n");
}

}  // namespace

std::optional<std::string> draw_fields(const std::vector<FieldPanel>& panels, const std::filesystem::path& folder,
                                       const std::string& name) {
  std::string commands;
  const Text out(commands);
  fmt::format_to(out,
                 "set multiplot layout 1,{}\nset view map\nset size ratio -1\nset pm3d map corners2color c1\n"
                 "unset key\nset xlabel 'x (Å)'\nset ylabel 'y (Å)' offset 1,0\nset border lw 0.5\nset colorbox\n",
                 panels.size());
  for (std::size_t i = 0; i < panels.size(); ++i) panel_commands(out, panels[i], i, panels.size());
  fmt::format_to(out, "unset multiplot\n");
  return draw(commands, folder, name, {panel_width * static_cast<int>(panels.size()), panel_height});
}

}  // namespace validate
