#include "compare/documents/plots/recording_plot.hpp"

#include <algorithm>
#include <filesystem>
#include <string>

namespace validate {
namespace {

/// More points than a drawing of this size shows.
constexpr int most_points = 2000;

/// A column in the unit that its numbers are read in.
struct Drawn {
  const RecordedColumn* column = nullptr;
  std::string label, unit;
  double factor = 1;

  Axis axis() const { return {.label = label, .unit = unit, .key = label + "_" + unit}; }
};

Drawn drawn(const std::optional<RecordedColumn>& column, const char* label) {
  if (!column) return {};
  if (column->unit == "m") return {&*column, label, "nm", 1e9};
  if (column->unit == "N") return {&*column, label, "nN", 1e9};
  return {&*column, label, column->unit, 1};
}

Drawn first_of(std::initializer_list<Drawn> list) {
  for (const Drawn& one : list)
    if (one.column) return one;
  return {};
}

Panel panel_of(const Recording& recording, const Drawn& x, const Drawn& y) {
  Panel panel{.x = x.axis(), .y = y.axis(), .legend = Legend::right_top};
  std::size_t from = 0;
  for (std::size_t s = 0; s < recording.segments.size(); ++s) {
    const RecordedSegment& segment = recording.segments[s];
    PlotCurve curve{
        .name = fmt::format("{} {}", s, to_string(segment.kind)), .colour = nth_colour(s), .line = Line{.width = 1}};
    const auto step = static_cast<std::size_t>(std::max(segment.points / most_points, 1));
    const std::size_t end = from + static_cast<std::size_t>(segment.points);
    for (std::size_t i = from; i < end; i += step) {
      curve.x.push_back(x.factor * x.column->values[i]);
      curve.y.push_back(y.factor * y.column->values[i]);
    }
    panel.curves.push_back(std::move(curve));
    from = end;
  }
  return panel;
}

}  // namespace

Plot recording_plot(const Recording& recording) {
  const RecordedColumns& c = recording.columns;
  const Drawn y = first_of({drawn(c.force, "force"), drawn(c.deflection, "deflection")});
  const Drawn x = first_of({drawn(c.height_measured, "height"), drawn(c.height_piezo, "height"),
                            drawn(c.depth, "depth"), drawn(c.tip_position, "tip position")});
  Plot plot{
      .title = fmt::format("{}, curve {}", std::filesystem::path(recording.file).filename().string(), recording.index)};
  if (!y.column) return plot;
  if (x.column) plot.panels.push_back(panel_of(recording, x, y));
  if (c.time) plot.panels.push_back(panel_of(recording, drawn(c.time, "time"), y));
  plot.columns = static_cast<int>(std::max<std::size_t>(plot.panels.size(), 1));
  plot.width = 550 * plot.columns;
  plot.height = 480;
  return plot;
}

}  // namespace validate
