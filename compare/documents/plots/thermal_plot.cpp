#include "compare/documents/plots/thermal_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace validate {
namespace {

bool known(const Run& run, std::size_t i) { return run.converged[i] && std::isfinite(run.thermal->force_ratio[i]); }

PlotCurve curve_of(std::string name, Colour colour) {
  PlotCurve curve{.name = std::move(name), .x = {}, .y = {}, .colour = colour};
  return curve;
}

void add_forces(Panel& panel, const Run& run, Colour cold_colour, Colour warm_colour) {
  const Thermal& t = *run.thermal;
  PlotCurve cold = curve_of(fmt::format("{}, T = 0", run.load), cold_colour);
  PlotCurve warm = curve_of(fmt::format("{}, {:g} K, vibrations", run.load, t.temperature_K), warm_colour);
  PlotCurve md = curve_of(fmt::format("{}, {:g} K, dynamics", run.load, t.temperature_K), warm_colour);
  cold.line = Line{Dash::solid, 1.6};
  warm.line = Line{Dash::dashed, 1.6};
  warm.points = Points{.marker = Marker::circle, .size = 0.7};
  md.points = Points{.marker = Marker::diamond, .size = 1.1, .open = true};
  for (std::size_t i = 0; i < run.depth_A.size(); ++i) {
    if (!known(run, i)) continue;
    cold.x.push_back(run.conjugate_depth_A[i]);
    cold.y.push_back(run.force_eV_per_A[i]);
    warm.x.push_back(run.conjugate_depth_A[i]);
    warm.y.push_back(run.force_eV_per_A[i] * t.force_ratio[i]);
    if (!t.md || !std::isfinite(t.md->mean_A[i])) continue;
    md.x.push_back(run.conjugate_depth_A[i] + t.md->mean_A[i]);
    md.y.push_back(run.force_eV_per_A[i]);
  }
  for (PlotCurve* curve : {&cold, &warm, &md})
    if (!curve->x.empty()) panel.curves.push_back(std::move(*curve));
}

/// Shifts of the depth at equal force, with the dynamics' 95 % as bars.
void add_shifts(Panel& panel, const Run& run, Colour colour) {
  const Thermal& t = *run.thermal;
  PlotCurve shift = curve_of(fmt::format("{}, vibrations", run.load), colour);
  PlotCurve md = curve_of(fmt::format("{}, dynamics", run.load), colour);
  PlotCurve bars = curve_of(fmt::format("{}, dynamics, 95 %", run.load), colour);
  shift.line = Line{Dash::dashed, 1.6};
  shift.points = Points{.marker = Marker::circle, .size = 0.7};
  md.points = Points{.marker = Marker::diamond, .size = 1.1, .open = true};
  bars.line = Line{Dash::solid, 1};
  bars.strokes = true;
  bars.in_legend = false;
  for (std::size_t i = 0; i < run.depth_A.size(); ++i) {
    if (!known(run, i)) continue;
    shift.x.push_back(run.conjugate_depth_A[i]);
    shift.y.push_back(t.depth_shift_A[i]);
    if (!t.md || !std::isfinite(t.md->mean_A[i])) continue;
    md.x.push_back(run.conjugate_depth_A[i]);
    md.y.push_back(t.md->mean_A[i]);
    for (const double sign : {-2.0, 2.0}) {
      bars.x.push_back(run.conjugate_depth_A[i]);
      bars.y.push_back(t.md->mean_A[i] + sign * t.md->error_A[i]);
    }
  }
  for (PlotCurve* curve : {&shift, &md, &bars})
    if (!curve->x.empty()) panel.curves.push_back(std::move(*curve));
}

}  // namespace

Plot thermal_plot(const Result& result) {
  const Axis depth{.label = "conjugate depth", .unit = "Å", .key = "conjugate_depth_A", .low = 0};
  Panel forces{.title = "at T = 0 and at the temperature",
               .x = depth,
               .y = {.label = "force", .unit = "eV/Å", .key = "force_eV_per_A", .low = 0},
               .legend = Legend::left_top};
  Panel shifts{.title = "depth at equal force, less that at T = 0",
               .x = depth,
               .y = {.label = "shift", .unit = "Å", .key = "depth_shift_A"},
               .legend = Legend::right_bottom};
  std::size_t colour = 0;
  for (const Run& run : result.runs) {
    if (!run.thermal) continue;
    add_forces(forces, run, nth_colour(colour), nth_colour(colour + 1));
    add_shifts(shifts, run, nth_colour(colour + 1));
    colour += 2;
  }
  if (shifts.curves.empty()) return {};
  shifts.marks.push_back({.along = Along::y, .at = 0});
  return {.panels = {std::move(forces), std::move(shifts)}, .columns = 2, .width = 1200, .height = 560};
}

}  // namespace validate
