#include "compare/documents/plots/gnuplot_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <vector>

namespace validate {
namespace {

std::string number(double value) { return std::isfinite(value) ? fmt::format("{:.7g}", value) : "NaN"; }

std::string block(const PlotCurve& curve) {
  std::string text;
  const std::vector<double>& third = curve.value.empty() ? curve.y_high : curve.value;
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    text += number(curve.x[i]) + " " + number(curve.y[i]) + (third.empty() ? "" : " " + number(third[i])) + "\n";
    if (curve.strokes && i % 2 == 1) text += "\n\n";
  }
  return text;
}

using Corners = std::array<Eigen::Vector2d, 4>;  // around the piece

/// Two triangles that share a side, as one piece around that diagonal.
std::optional<Corners> joined(const std::array<Eigen::Vector2d, 3>& one, const std::array<Eigen::Vector2d, 3>& other) {
  const auto lies_apart = [](const Eigen::Vector2d& corner, const auto& triangle) {
    return std::ranges::find(triangle, corner) == triangle.end();
  };
  if (std::ranges::count_if(one, [&](const auto& corner) { return lies_apart(corner, other); }) != 1) return {};
  const auto apart = std::ranges::find_if(one, [&](const auto& corner) { return lies_apart(corner, other); });
  const auto k = static_cast<std::size_t>(apart - one.begin());
  return Corners{*apart, one[(k + 1) % 3],
                 *std::ranges::find_if(other, [&](const auto& corner) { return lies_apart(corner, one); }),
                 one[(k + 2) % 3]};
}

/// All triangles as one surface of two rows of points, between which pm3d fills the quadrilaterals; those between the
/// triangles are not numbers and stay open. A surface for each would take 9 kB of gnuplot's memory. Neighbours of one
/// colour are drawn at once, which takes half the time.
std::string block(const TriangleMap& map) {
  DataRange range;
  for (const double value : map.value) range.add(value);
  const double one_colour = (range.high - range.low) / 512;
  std::string first, second;
  const auto add = [](std::string& row, const Eigen::Vector2d& a, const Eigen::Vector2d& b, double value) {
    fmt::format_to(std::back_inserter(row), "{:.6g} {:.6g} {:.6g}\n{:.6g} {:.6g} {:.6g}\nNaN NaN NaN\n", a.x(), a.y(),
                   value, b.x(), b.y(), value);
  };
  const std::vector<int> whole = {1}, mirrored = {1, -1};
  for (const int sx : map.quarter ? mirrored : whole)
    for (const int sy : map.quarter ? mirrored : whole)
      for (std::size_t t = 0; t < map.value.size(); ++t) {
        const auto& alone = map.corners[t];
        Corners at = {alone[0], alone[1], alone[2], alone[2]};
        double value = map.value[t];
        if (t + 1 < map.value.size() && std::abs(map.value[t + 1] - value) <= one_colour)
          if (const auto both = joined(alone, map.corners[t + 1])) {
            at = *both;
            value = (value + map.value[++t]) / 2;
          }
        for (Eigen::Vector2d& corner : at) corner = corner.cwiseProduct(Eigen::Vector2d(sx, sy));
        add(first, at[0], at[1], value);
        add(second, at[3], at[2], value);
      }
  return first + "\n" + second;
}

/// Boxes of one of the shares, upon those before it of the same sign.
std::string block(const std::vector<StackedBars>& all, std::size_t which) {
  constexpr double half_width = 0.35;
  std::string text;
  for (std::size_t i = 0; i < all[which].y.size(); ++i) {
    const double height = all[which].y[i];
    if (!std::isfinite(height)) continue;
    double base = 0;
    for (std::size_t k = 0; k < which; ++k)
      if (std::isfinite(all[k].y[i]) && (all[k].y[i] < 0) == (height < 0)) base += all[k].y[i];
    const auto [low, high] = std::minmax({base, base + height});
    const auto x = static_cast<double>(i);
    fmt::format_to(std::back_inserter(text), "{:g} {:.6g} {:g} {:g} {:.6g} {:.6g}\n", x, base + height, x - half_width,
                   x + half_width, low, high);
  }
  return text;
}

}  // namespace

void DataRange::add(double value) {
  if (!std::isfinite(value)) return;
  low = std::min(low, value);
  high = std::max(high, value);
}

std::string curve_block(std::size_t panel, std::size_t curve) { return fmt::format("$p{}c{}", panel, curve); }
std::string map_block(std::size_t panel, std::size_t map) { return fmt::format("$p{}m{}", panel, map); }
std::string bar_block(std::size_t panel, std::size_t bars) { return fmt::format("$p{}b{}", panel, bars); }

std::string gnuplot_data(const Plot& plot) {
  std::string text;
  const auto add = [&](const std::string& name, const std::string& rows) {
    text += name + " << EOD\n" + rows + "EOD\n";
  };
  for (std::size_t p = 0; p < plot.panels.size(); ++p) {
    const Panel& panel = plot.panels[p];
    for (std::size_t m = 0; m < panel.maps.size(); ++m) add(map_block(p, m), block(panel.maps[m]));
    for (std::size_t b = 0; b < panel.bars.size(); ++b) add(bar_block(p, b), block(panel.bars, b));
    for (std::size_t c = 0; c < panel.curves.size(); ++c) add(curve_block(p, c), block(panel.curves[c]));
  }
  return text;
}

}  // namespace validate
