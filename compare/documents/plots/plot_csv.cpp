#include "compare/documents/plots/plot_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace validate {
namespace {

constexpr std::size_t most_triangles = 20000;

std::string quoted(const std::string& text) {
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? std::string("\"\"") : std::string(1, c == '\n' ? ' ' : c);
  return cell + "\"";
}

/// The title, or where there is none the number: 1, 2, …
std::string panel_name(const Plot& plot, std::size_t index) {
  const std::string& title = plot.panels[index].title;
  return quoted(title.empty() ? fmt::format("{}", index + 1) : title);
}

class Rows {
 public:
  Rows(const Panel& panel, std::string name, std::string& text) : panel_(panel), name_(std::move(name)), text_(text) {}

  void add(const std::string& name, double x, double y, const std::string& last, const std::string& corners) {
    if (!std::isfinite(x) || !std::isfinite(y)) return;
    fmt::format_to(std::back_inserter(text_), "{},{},{},{},{},{},{}{}\n", name_, quoted(name), panel_.x.key,
                   panel_.y.key, x, y, last, corners);
  }

 private:
  const Panel& panel_;
  std::string name_;
  std::string& text_;
};

void add_curve(Rows& rows, const PlotCurve& curve, const std::string& no_corners) {
  const std::vector<double>& third = curve.value.empty() ? curve.y_high : curve.value;
  for (std::size_t i = 0; i < curve.x.size(); ++i)
    rows.add(curve.name, curve.x[i], curve.y[i], third.empty() ? "" : fmt::format("{}", third[i]), no_corners);
}

void add_map(Rows& rows, const TriangleMap& map, Corners written) {
  for (std::size_t i = 0; i < map.value.size(); ++i) {
    const auto& c = map.corners[i];
    const Eigen::Vector2d middle = (c[0] + c[1] + c[2]) / 3;
    std::string corners;
    if (written == Corners::written)
      for (const Eigen::Vector2d& corner : c)
        fmt::format_to(std::back_inserter(corners), ",{:.6g},{:.6g}", corner.x(), corner.y());
    rows.add(map.key, middle.x(), middle.y(), fmt::format("{}", map.value[i]), corners);
  }
}

std::size_t triangles_of(const Plot& plot) {
  std::size_t count = 0;
  for (const Panel& panel : plot.panels)
    for (const TriangleMap& map : panel.maps) count += map.value.size();
  return count;
}

}  // namespace

std::string plot_rows(const Plot& plot, Corners corners) {
  const bool written = corners == Corners::written;
  std::string text = "panel,curve,x_key,y_key,x,y,upper_or_value";
  text += written ? ",x1_A,y1_A,x2_A,y2_A,x3_A,y3_A\n" : "\n";
  for (std::size_t p = 0; p < plot.panels.size(); ++p) {
    const Panel& panel = plot.panels[p];
    Rows rows(panel, panel_name(plot, p), text);
    const std::string no_corners = written ? ",,,,,," : "";
    for (const StackedBars& bars : panel.bars)
      for (std::size_t i = 0; i < bars.y.size(); ++i)
        rows.add(bars.name, static_cast<double>(i), bars.y[i], "", no_corners);
    for (const PlotCurve& curve : panel.curves) add_curve(rows, curve, no_corners);
    for (const TriangleMap& map : panel.maps) add_map(rows, map, corners);
  }
  return text;
}

std::string plot_csv(const Plot& plot, const std::string& fields_in) {
  std::string text = plot.title.empty() ? "" : "# title: " + plot.title + "\n";
  for (std::size_t p = 0; p < plot.panels.size(); ++p)
    fmt::format_to(std::back_inserter(text), "# panel {}: {} against {}\n", panel_name(plot, p),
                   axis_text(plot.panels[p].y), axis_text(plot.panels[p].x));
  const std::size_t triangles = triangles_of(plot);
  if (triangles > most_triangles) {
    Plot without = plot;
    for (Panel& panel : without.panels) panel.maps.clear();
    return text + fmt::format("# maps: {} triangles, left to {}\n", triangles, fields_in) +
           plot_rows(without, Corners::left_out);
  }
  const auto quarter = [](const Panel& panel) { return std::ranges::any_of(panel.maps, &TriangleMap::quarter); };
  if (std::ranges::any_of(plot.panels, quarter)) text += "# maps: one quarter; the others are its mirror images\n";
  return text + plot_rows(plot, triangles > 0 ? Corners::written : Corners::left_out);
}

}  // namespace validate
