#include "compare/documents/plots/residual_panel.hpp"

#include <algorithm>
#include <cmath>

#include "compare/documents/sentences/shown_units.hpp"

namespace validate {
namespace {

// The panel shows differences up to this many per cent; what is beyond is in ratio.svg and in the table.
constexpr double most_percent = 12;

const Comparison* comparison_of(const Result& result, LoadKind load) {
  const auto found = std::ranges::find(result.comparisons, load, &Comparison::load);
  return found == result.comparisons.end() ? nullptr : &*found;
}

bool has_values(const std::vector<double>& values) {
  return std::ranges::any_of(values, [](double v) { return std::isfinite(v); });
}

/// Points outside the artefact zone joined by a line, those inside open.
void add_differences(Panel& panel, const Comparison& c, const std::vector<double>& ratio, const ShownUnit& length,
                     Points points) {
  PlotCurve usable{.name = "atoms / continuum − 1",
                   .x = {},
                   .y = {},
                   .colour = colour_of_atoms,
                   .line = Line{.width = 1.2},
                   .points = points,
                   .in_legend = false};
  PlotCurve artefact = usable;
  artefact.name += ", artefact zone";
  artefact.line.reset();
  artefact.points->open = true;
  for (std::size_t i = 0; i < ratio.size() && i < c.depth_A.size(); ++i) {
    if (!std::isfinite(ratio[i])) continue;
    PlotCurve& curve = c.regime[i] == Regime::artefact ? artefact : usable;
    curve.x.push_back(length.of(c.depth_A[i]));
    curve.y.push_back(100 * (ratio[i] - 1));
  }
  for (PlotCurve* curve : {&artefact, &usable})
    if (!curve->x.empty()) panel.curves.push_back(std::move(*curve));
}

void add_bars(Panel& panel, const Agreement& agreement, const ShownUnit& length) {
  PlotCurve bars{.name = "95 %",
                 .x = {},
                 .y = {},
                 .colour = Colour::dark_grey,
                 .line = Line{.width = 1.2},
                 .in_legend = false,
                 .strokes = true};
  for (const JudgedRatio& judged : agreement.ratios)
    for (const double side : {-1.0, 1.0}) {
      bars.x.push_back(length.of(judged.depth_A));
      bars.y.push_back(100 * (judged.ratio - 1 + side * judged.expanded()));
    }
  panel.curves.push_back(std::move(bars));
}

/// Both ways alike: the tolerance and the differences, but not those that would make all others small.
double half_range(const Panel& panel, double tolerance_percent) {
  double largest = 2 * tolerance_percent;
  for (const PlotCurve& curve : panel.curves)
    for (const double value : curve.y) largest = std::max(largest, 1.1 * std::abs(value));
  return std::min(largest, std::max(most_percent, 2 * tolerance_percent));
}

}  // namespace

std::optional<Panel> residual_panel(const Result& result, LoadKind load, double depth_end) {
  const Comparison* c = comparison_of(result, load);
  if (!c) return std::nullopt;
  const bool sheet = has_values(c->sheet_ratio);
  if (!sheet && !has_values(c->force_ratio)) return std::nullopt;
  const ShownUnit length = shown_units(result.resolved).length;
  Panel panel{.title = {},
              .x = {.label = "depth", .unit = length.name, .key = "depth_" + length.key, .low = 0, .high = depth_end},
              .y = {.label = sheet ? "atoms − sheet" : "atoms − membrane", .unit = "%", .key = "difference_percent"}};
  const Case& asked = result.resolved;
  const bool judged = result.agreement && result.agreement->load == load;
  if (judged) add_bars(panel, *result.agreement, length);
  add_differences(panel, *c, sheet ? c->sheet_ratio : c->force_ratio, length,
                  {.marker = load == LoadKind::disc ? Marker::square : Marker::circle, .size = 0.9});
  const double tolerance = 100 * asked.tolerance, range = half_range(panel, tolerance);
  panel.y.low = -range;
  panel.y.high = range;
  panel.marks = {{.along = Along::y, .at = 0, .colour = Colour::dark_grey}};
  if (judged) {
    panel.zones = {{.along = Along::y, .from = -tolerance, .to = tolerance, .colour = Colour::green}};
    const double a_A = result.sheet ? result.sheet->effective_radius_A : asked.radius_A;
    for (const double end : result.agreement->window)
      panel.marks.push_back({.along = Along::x, .at = length.of(end * a_A), .dash = Dash::dotted});
  }
  return panel;
}

}  // namespace validate
