#include "compare/documents/plots/window_scan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/base/units.hpp"

namespace validate {
namespace {

/// A model's readings of a curve.
struct Scanned {
  const Run* run;
  const Fit* fit;
};

/// Of the atoms Eq. 16 and the fit to quote, of a continuum that is known the first; one window is no scan.
std::vector<Scanned> scanned(const Result& result) {
  std::vector<Scanned> found;
  for (const Run& run : result.runs) {
    const bool calibrated = run.model == Model::membrane && run.constants == Constants::calibrated;
    if (run.constants == Constants::paper || calibrated) continue;
    for (const Fit& fit : run.fits)
      if (fit.scan.depth_max_A.size() > 1 && (&fit == &run.fits.front() || (run.is_atomistic() && fit.recommended)))
        found.push_back({&run, &fit});
  }
  return found;
}

void add_curve(Panel& panel, const Scanned& of, std::size_t number, double depth_factor,
               const std::vector<double>& values) {
  const std::string model = of.run->is_atomistic() ? "atoms" : std::string(to_string(of.run->model));
  PlotCurve curve{.name = fmt::format("{} read by {}", model, of.fit->model == "eq16" ? "Eq. 16" : of.fit->model),
                  .x = of.fit->scan.depth_max_A,
                  .y = values,
                  .colour = nth_colour(number),
                  .line = Line{.dash = of.run->is_atomistic() ? Dash::solid : Dash::dashed},
                  .points = Points{.marker = nth_marker(number), .size = 0.6}};
  for (double& depth : curve.x) depth *= depth_factor;
  for (double& value : curve.y) value *= N_per_m_per_eV_per_A2;
  panel.curves.push_back(std::move(curve));
}

/// A dashed line at every value that the constants of a curve have, across the windows.
void add_known(Panel& panel, std::vector<double> known_eV_per_A2) {
  double end = 0;
  for (const PlotCurve& curve : panel.curves) end = std::max(end, std::ranges::max(curve.x));
  std::erase_if(known_eV_per_A2, [](double value) { return !std::isfinite(value); });
  std::ranges::sort(known_eV_per_A2);
  const auto again = std::ranges::unique(known_eV_per_A2);
  known_eV_per_A2.erase(again.begin(), again.end());
  for (const double value : known_eV_per_A2)
    panel.curves.push_back({.name = "known",
                            .x = {0, end},
                            .y = std::vector<double>(2, N_per_m_per_eV_per_A2 * value),
                            .colour = Colour::dark_grey,
                            .line = Line{.dash = Dash::dashed, .width = 1},
                            .in_legend = false});
}

std::vector<LoadKind> loads_of(const std::vector<Scanned>& scans) {
  std::vector<LoadKind> loads;
  for (const Scanned& of : scans)
    if (std::ranges::find(loads, of.run->load) == loads.end()) loads.push_back(of.run->load);
  return loads;
}

/// E·h, or the pretension, of all scans of a load.
Panel panel_of(const std::vector<Scanned>& scans, LoadKind load, const Axis& depth, bool modulus) {
  Panel panel{.x = depth,
              .y = modulus ? Axis{.label = "E·h", .unit = "N/m", .key = "Eh_N_per_m"}
                           : Axis{.label = "pretension", .unit = "N/m", .key = "pretension_N_per_m"}};
  if (modulus) panel.title = fmt::format("{} load", load);
  const double factor = depth.unit == "nm" ? 0.1 : 1;
  std::vector<double> known;
  for (const Scanned& of : scans) {
    if (of.run->load != load) continue;
    const WindowScan& scan = of.fit->scan;
    add_curve(panel, of, panel.curves.size(), factor, modulus ? scan.Eh_eV_per_A2 : scan.pretension_eV_per_A2);
    known.push_back(modulus ? of.run->Eh_eV_per_A2 : of.run->pretension_eV_per_A2);
  }
  add_known(panel, known);
  return panel;
}

}  // namespace

Plot window_scan_plot(const Result& result) {
  const std::vector<Scanned> scans = scanned(result);
  if (scans.empty()) return {};
  // Depths of drums are read in nm.
  const bool nm = std::ranges::any_of(scans, [](const Scanned& of) { return of.fit->scan.depth_max_A.back() > 100; });
  const Axis depth{
      .label = "largest depth fitted", .unit = nm ? "nm" : "Å", .key = nm ? "depth_max_nm" : "depth_max_A", .low = 0};
  const std::vector<LoadKind> loads = loads_of(scans);
  Plot plot{.columns = static_cast<int>(loads.size()), .height = 640, .row_shares = {0.5, 0.5}};
  for (const bool modulus : {true, false})
    for (const LoadKind load : loads) plot.panels.push_back(panel_of(scans, load, depth, modulus));
  plot.panels[loads.size()].legend = Legend::left_top;  // pretensions begin low
  return plot;
}

}  // namespace validate
