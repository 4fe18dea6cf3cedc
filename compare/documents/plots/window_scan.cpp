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

void add_curve(Panel& panel, const Scanned& of, Colour colour, double depth_factor, const std::vector<double>& values) {
  const std::string model = of.run->is_atomistic() ? "atoms" : std::string(to_string(of.run->model));
  PlotCurve curve{
      .name = fmt::format("{}, {}, {}", model, of.run->load, of.fit->model == "eq16" ? "Eq. 16" : of.fit->model),
      .x = of.fit->scan.depth_max_A,
      .y = values,
      .colour = colour,
      .line = Line{.dash = of.run->is_atomistic() ? Dash::solid : Dash::dashed},
      .points = Points{.size = 0.6}};
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

}  // namespace

Plot window_scan_plot(const Result& result) {
  const std::vector<Scanned> runs = scanned(result);
  if (runs.empty()) return {};
  // Depths of drums are read in nm.
  const bool nm = std::ranges::any_of(runs, [](const Scanned& of) { return of.fit->scan.depth_max_A.back() > 100; });
  const Axis depth{
      .label = "largest depth fitted", .unit = nm ? "nm" : "Å", .key = nm ? "depth_max_nm" : "depth_max_A", .low = 0};
  Panel modulus{
      .title = {}, .x = depth, .y = {.label = "E·h", .unit = "N/m", .key = "Eh_N_per_m"}, .legend = Legend::above};
  Panel pretension = modulus;
  pretension.y = {.label = "pretension", .unit = "N/m", .key = "pretension_N_per_m"};
  std::vector<double> known_modulus, known_pretension;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const WindowScan& scan = runs[i].fit->scan;
    add_curve(modulus, runs[i], nth_colour(i), nm ? 0.1 : 1, scan.Eh_eV_per_A2);
    add_curve(pretension, runs[i], nth_colour(i), nm ? 0.1 : 1, scan.pretension_eV_per_A2);
    known_modulus.push_back(runs[i].run->Eh_eV_per_A2);
    known_pretension.push_back(runs[i].run->pretension_eV_per_A2);
  }
  add_known(modulus, known_modulus);
  add_known(pretension, known_pretension);
  return {.panels = {std::move(modulus), std::move(pretension)}, .columns = 2, .width = 900, .height = 420};
}

}  // namespace validate
