#include "compare/documents/plots/many_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/base/units.hpp"

namespace validate {
namespace {

constexpr double nm_per_um = 1000, height_nm_per_A = 0.1;

struct MappedValue {
  std::string label, unit, key;
  double CurveRow::*value;
  double factor;
};

std::vector<const CurveRow*> used_rows(const ManyCurves& many) {
  std::vector<const CurveRow*> rows;
  for (const CurveRow& row : many.rows)
    if (row.skipped.empty()) rows.push_back(&row);
  return rows;
}

double quantile(std::vector<double> values, double share) {
  std::ranges::sort(values);
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

Panel map_panel(const ManyCurves& many, const MappedValue& q) {
  Panel panel{.title = q.label,
              .x = {.label = "x", .unit = "um", .key = "x_um"},
              .y = {.label = "y", .unit = "um", .key = "y_um"},
              .equal_axes = true};
  panel.scale.label = q.unit;
  PlotCurve dots{.name = q.key, .points = Points{.marker = Marker::square, .size = 1.2}, .in_legend = false},
      crosses{.name = "skipped", .colour = Colour::grey, .points = Points{.size = 0.6, .open = true}};
  for (const CurveRow& row : many.rows) {
    if (!std::isfinite(row.x_nm) || !std::isfinite(row.y_nm)) continue;
    const bool shown = row.skipped.empty() && std::isfinite(row.*q.value);
    PlotCurve& curve = shown ? dots : crosses;
    curve.x.push_back(row.x_nm / nm_per_um);
    curve.y.push_back(row.y_nm / nm_per_um);
    if (shown) curve.value.push_back(q.factor * row.*q.value);
  }
  if (dots.x.empty()) return panel;
  // A few that are far off must not take all the colours.
  panel.scale.low = quantile(dots.value, 0.02);
  panel.scale.high = quantile(dots.value, 0.98);
  panel.curves.push_back(std::move(dots));
  if (!crosses.x.empty()) panel.curves.push_back(std::move(crosses));
  return panel;
}

/// Counts as a line of steps.
PlotCurve counted(const std::vector<double>& values, double low, double high) {
  constexpr std::size_t fewest = 6, most = 40;
  const auto bins = std::clamp<std::size_t>(static_cast<std::size_t>(std::sqrt(static_cast<double>(values.size()))) + 1,
                                            fewest, most);
  const double width = (high - low) / static_cast<double>(bins);
  std::vector<double> counts(bins, 0);
  for (const double value : values)
    if (value >= low && value <= high) ++counts[std::min(bins - 1, static_cast<std::size_t>((value - low) / width))];
  PlotCurve curve{.name = "curves", .x = {low}, .y = {0}, .colour = colour_of_membrane, .line = Line{}};
  for (std::size_t i = 0; i < bins; ++i) {
    const double from = low + width * static_cast<double>(i);
    for (const double x : {from, from + width}) curve.x.push_back(x), curve.y.push_back(counts[i]);
  }
  curve.x.push_back(high), curve.y.push_back(0);
  return curve;
}

Panel histogram(const ManyCurves& many, const MappedValue& q, double mean, double between, double within) {
  Panel panel{.x = {.label = q.label, .unit = q.unit, .key = q.key},
              .y = {.label = "curves", .unit = "", .key = "curves", .low = 0},
              .legend = Legend::above};
  std::vector<double> values;
  for (const CurveRow* row : used_rows(many))
    if (std::isfinite(row->*q.value)) values.push_back(q.factor * row->*q.value);
  if (values.size() < 2) return panel;
  const double middle = quantile(values, 0.5), far = 3 * (quantile(values, 0.84) - quantile(values, 0.16));
  double low = std::max(quantile(values, 0), middle - far), high = std::min(quantile(values, 1), middle + far);
  if (!(high > low)) low = middle - 0.5, high = middle + 0.5;
  panel.curves.push_back(counted(values, low, high));
  panel.marks.push_back({.along = Along::x, .at = q.factor * mean});
  const double spread = q.factor * std::hypot(between, within);
  panel.zones.push_back({.along = Along::x,
                         .from = q.factor * mean - spread,
                         .to = q.factor * mean + spread,
                         .name = "mean ± spread and noise of one"});
  return panel;
}

const MappedValue modulus{"E·h", "N/m", "Eh_N_per_m", &CurveRow::Eh_eV_per_A2, N_per_m_per_eV_per_A2},
    tension{"pretension", "N/m", "pretension_N_per_m", &CurveRow::pretension_eV_per_A2, N_per_m_per_eV_per_A2},
    height{"height of the contact", "nm", "height_nm", &CurveRow::height_A, height_nm_per_A};

}  // namespace

Plot many_map(const ManyCurves& many) {
  Plot plot{.columns = 3, .width = 1500, .height = 470};
  for (const MappedValue& q : {modulus, tension, height})
    if (Panel panel = map_panel(many, q); !panel.curves.empty()) plot.panels.push_back(std::move(panel));
  return plot;
}

Plot many_histograms(const ManyCurves& many) {
  Plot plot{.columns = 2, .width = 1000, .height = 460};
  if (many.means.empty() || many.means.front().count < 2) return plot;
  const SpreadMean& m = many.means.front();
  Panel Eh = histogram(many, modulus, m.Eh_eV_per_A2, m.Eh_between_eV_per_A2, m.Eh_within_eV_per_A2);
  for (const JointFit& joint : many.joint)
    Eh.marks.push_back({.along = Along::x,
                        .at = N_per_m_per_eV_per_A2 * joint.Eh_eV_per_A2,
                        .dash = Dash::dashed,
                        .colour = Colour::vermilion});
  plot.panels = {std::move(Eh), histogram(many, tension, m.pretension_eV_per_A2, m.pretension_between_eV_per_A2,
                                          m.pretension_within_eV_per_A2)};
  return plot;
}

}  // namespace validate
