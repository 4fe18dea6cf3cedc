#include "compare/documents/plots/ratio.hpp"

#include <array>
#include <cmath>

namespace validate {
namespace {

/// Points filled outside the artefact zone, open inside, joined by a line; nothing where no ratio is known.
void add_curve(std::vector<PlotCurve>& all, const Comparison& c, const std::vector<double>& ratio, Colour colour,
               Dash dash, const std::string& name) {
  PlotCurve usable{.name = name, .x = {}, .y = {}, .colour = colour};
  usable.line = Line{.dash = dash, .width = 1.6};
  usable.points = Points{};
  PlotCurve artefact = usable;
  artefact.name += ", artefact zone";
  artefact.points->open = true;
  artefact.in_legend = false;
  for (std::size_t i = 0; i < ratio.size() && i < c.depth_A.size(); ++i) {
    if (!std::isfinite(ratio[i])) continue;
    PlotCurve& curve = c.regime[i] == Regime::artefact ? artefact : usable;
    if (&curve == &artefact && curve.x.empty() && !usable.x.empty()) {  // the line has no gap
      curve.x.push_back(usable.x.back());
      curve.y.push_back(usable.y.back());
    }
    curve.x.push_back(c.depth_relative[i]);
    curve.y.push_back(ratio[i]);
  }
  if (!artefact.x.empty()) all.push_back(std::move(artefact));
  if (!usable.x.empty()) all.push_back(std::move(usable));  // its filled points upon the other's first
}

std::vector<PlotCurve> curves_of(const Result& result) {
  std::vector<PlotCurve> all;
  for (std::size_t i = 0; i < result.comparisons.size(); ++i) {
    const Comparison& c = result.comparisons[i];
    const Colour colour = nth_colour(i);
    add_curve(all, c, c.force_ratio, colour, Dash::long_dash_dotted,
              fmt::format("{}", c.load) + ", membrane, card constants");
    add_curve(all, c, c.calibrated_membrane_ratio, colour, Dash::dotted,
              fmt::format("{}", c.load) + ", membrane, calibrated law");
    add_curve(all, c, c.sheet_ratio, colour, Dash::solid, fmt::format("{}", c.load) + ", sheet, calibrated law");
  }
  return all;
}

}  // namespace

Plot ratio_plot(const Result& result) {
  Panel panel{.title = {},
              .x = {.label = "depth / effective radius", .unit = {}, .key = "depth_relative", .low = 0},
              .y = {.label = "force: atoms / continuum", .unit = {}, .key = "force_ratio", .logarithmic = true},
              .legend = Legend::right_top,
              .curves = curves_of(result)};
  if (panel.curves.empty()) return {};
  const Case& c = result.resolved;
  panel.zones = {{.along = Along::y, .from = 1 - c.tolerance, .to = 1 + c.tolerance, .colour = Colour::green}};
  const auto judged = result.agreement ? result.agreement->window : std::array{c.window.at(0), c.window.at(1)};
  for (const double end : judged)
    panel.marks.push_back({.along = Along::x, .at = end, .dash = Dash::dotted, .colour = Colour::dark_grey});
  return {.panels = {std::move(panel)}, .width = 900, .height = 480};
}

}  // namespace validate
