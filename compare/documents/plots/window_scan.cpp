#include "compare/documents/plots/window_scan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/base/units.hpp"

namespace validate {
namespace {

/// One window is no scan.
std::vector<const Run*> scanned(const Result& result) {
  std::vector<const Run*> runs;
  for (const Run& run : result.runs) {
    const bool calibrated = run.model == Model::membrane && run.constants == Constants::calibrated;
    if (run.scan.depth_max_A.size() > 1 && run.constants != Constants::paper && !calibrated) runs.push_back(&run);
  }
  return runs;
}

void add_curve(Panel& panel, const Run& run, Colour colour, double depth_factor, const std::vector<double>& values) {
  PlotCurve curve{
      .name = fmt::format("{}, {}", run.model == Model::atomistic ? "atoms" : to_string(run.model), run.load),
      .x = run.scan.depth_max_A,
      .y = values,
      .colour = colour,
      .line = Line{},
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
  const std::vector<const Run*> runs = scanned(result);
  if (runs.empty()) return {};
  // Depths of drums are read in nm.
  const bool nm = std::ranges::any_of(runs, [](const Run* run) { return run->scan.depth_max_A.back() > 100; });
  const Axis depth{
      .label = "largest depth fitted", .unit = nm ? "nm" : "Å", .key = nm ? "depth_max_nm" : "depth_max_A", .low = 0};
  Panel modulus{
      .title = {}, .x = depth, .y = {.label = "E·h", .unit = "N/m", .key = "Eh_N_per_m"}, .legend = Legend::above};
  Panel pretension = modulus;
  pretension.y = {.label = "pretension", .unit = "N/m", .key = "pretension_N_per_m"};
  std::vector<double> known_modulus, known_pretension;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Run& run = *runs[i];
    add_curve(modulus, run, nth_colour(i), nm ? 0.1 : 1, run.scan.Eh_eV_per_A2);
    add_curve(pretension, run, nth_colour(i), nm ? 0.1 : 1, run.scan.pretension_eV_per_A2);
    known_modulus.push_back(run.Eh_eV_per_A2);
    known_pretension.push_back(run.pretension_eV_per_A2);
  }
  add_known(modulus, known_modulus);
  add_known(pretension, known_pretension);
  return {.panels = {std::move(modulus), std::move(pretension)}, .columns = 2, .width = 900, .height = 420};
}

}  // namespace validate
