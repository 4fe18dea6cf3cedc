#include "compare/documents/plots/force_depth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/fitting/curve.hpp"
#include "compare/fitting/models/eq16.hpp"

namespace validate {

namespace {

constexpr int pieces = 200;  // of a smooth curve

std::vector<LoadKind> loads_of(const Result& result) {
  std::vector<LoadKind> loads;
  for (const Run& run : result.runs) {
    if (std::ranges::find(loads, run.load) == loads.end()) loads.push_back(run.load);
  }
  return loads;
}

void add_point(PlotCurve& curve, double depth, double force) {
  curve.x.push_back(depth);
  curve.y.push_back(force);
}

/// Through the computed points as the comparison interpolates them. It starts at the first of them: nothing is known
/// below.
void add_smooth_points(PlotCurve& smooth, const Run& run) {
  const Curve curve(run);
  for (int i = 0; i <= pieces; ++i) {
    const double depth = std::lerp(curve.lowest_A(), curve.highest_A(), static_cast<double>(i) / pieces);
    if (const auto force = curve.at(depth)) add_point(smooth, depth, *force);
  }
}

// A law that is not the paper's.
std::string law_of(const Run& run) {
  return run.law.empty() || run.law == MembraneLaw{}.name ? "" : fmt::format(" ({})", run.law);
}

// The sheet solid, membranes thin: dash-dotted, dashed with the paper's constants. A calibrated membrane is in the
// ratios.
void add_continuum(std::vector<PlotCurve>& all, const Run& run, Colour colour) {
  if (usable_points(run).size() < 2) return;
  const bool sheet = run.model == Model::sheet, paper = run.constants == Constants::paper;
  if (!sheet && run.constants == Constants::calibrated) return;
  PlotCurve curve{.name = sheet ? fmt::format("sheet, {}, calibrated law with bending", run.load)
                                : fmt::format("membrane{}, {}, {} constants", law_of(run), run.load, *run.constants),
                  .x = {},
                  .y = {},
                  .colour = colour,
                  .line = Line{sheet   ? Dash::solid
                               : paper ? Dash::dashed
                                       : Dash::long_dash_dotted,
                               sheet ? 2.6 : 1.3}};
  add_smooth_points(curve, run);
  all.push_back(std::move(curve));
}

void add_atoms(std::vector<PlotCurve>& all, const Run& run, std::size_t load, double artefact_bond_A) {
  constexpr Marker markers[] = {Marker::circle, Marker::square, Marker::triangle, Marker::diamond};
  Points points{.marker = markers[load % std::size(markers)], .size = 1};
  PlotCurve usable{.name = fmt::format("atoms, {}", run.load), .x = {}, .y = {}, .colour = nth_colour(load)};
  usable.points = points;
  for (const std::size_t i : usable_points(run)) add_point(usable, run.depth_A[i], run.force_eV_per_A[i]);

  PlotCurve artefact{.name = fmt::format("atoms, {}, bond ≥ {:.2f} Å", run.load, artefact_bond_A),
                     .x = {},
                     .y = {},
                     .colour = nth_colour(load)};
  points.open = true;
  artefact.points = points;
  for (std::size_t i = 0; i < run.depth_A.size(); ++i) {
    if (run.atoms().artefact[i] && run.converged[i]) add_point(artefact, run.depth_A[i], run.force_eV_per_A[i]);
  }
  if (!usable.x.empty()) all.push_back(std::move(usable));
  if (!artefact.x.empty()) all.push_back(std::move(artefact));
}

double largest_depth(const Result& result) {
  double largest = 0;
  for (const Run& run : result.runs) {
    for (const double depth : run.depth_A) largest = std::max(largest, depth);
  }
  return largest;
}

double largest_force(const std::vector<PlotCurve>& all) {
  double largest = 0;
  for (const PlotCurve& curve : all) {
    for (const double force : curve.y) largest = std::max(largest, force);
  }
  return largest;
}

// Inside, top left, where force curves leave room; beside the plot if one passes through there after all.
Legend legend_place(const std::vector<PlotCurve>& all, double depth, double force) {
  for (const PlotCurve& curve : all) {
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      if (curve.x[i] < 0.5 * depth && curve.y[i] > 0.5 * force) return Legend::outside_right;
    }
  }
  return Legend::left_top;
}

// The closed form with the constants of the like-for-like membrane, or of whatever membrane there is.
void add_eq16(std::vector<PlotCurve>& all, const Result& result) {
  for (const Constants constants : {Constants::card, Constants::given, Constants::paper}) {
    const auto run = std::ranges::find_if(
        result.runs, [&](const Run& r) { return r.model == Model::membrane && r.constants == constants; });
    if (run == result.runs.end()) continue;
    const Eq16 closed_form{run->a_A, run->nu};
    const double end = largest_depth(result);
    PlotCurve curve{.name = fmt::format("Eq. 16, {} constants", to_string(constants)),
                    .x = {},
                    .y = {},
                    .line = Line{.width = 0.8}};
    for (int i = 0; i <= pieces; ++i) {
      const double depth = end * i / pieces;
      add_point(curve, depth, closed_form.force(depth, run->Eh_eV_per_A2, run->pretension_eV_per_A2));
    }
    all.push_back(std::move(curve));
    return;
  }
}

/// Curves of the runs and, where a load's longest bond first reached the artefact length, a band in its colour.
void add_runs(Panel& panel, const Result& result) {
  const std::vector<LoadKind> loads = loads_of(result);
  const auto load_of = [&](const Run& run) {
    return static_cast<std::size_t>(std::ranges::find(loads, run.load) - loads.begin());
  };
  for (const Run& run : result.runs) {
    if (run.model == Model::atomistic) add_atoms(panel.curves, run, load_of(run), artefact_bond_of(result));
    if (const std::optional<std::size_t> first = first_artefact(run))
      panel.zones.push_back({.from = run.depth_A[*first],
                             .colour = nth_colour(load_of(run)),
                             .name = fmt::format("artefact zone, {}", run.load),
                             .edge = true});
  }
  for (const Run& run : result.runs) {
    if (run.model != Model::atomistic) add_continuum(panel.curves, run, nth_colour(load_of(run)));
  }
}

std::string title_of(const Result& result) {
  const bool atoms = std::ranges::any_of(result.runs, [](const Run& r) { return r.model == Model::atomistic; });
  const double radius = result.resolved.radius_A;
  const std::string size = radius < 1000 ? fmt::format("R = {:g} Å", radius) : fmt::format("R = {:g} µm", radius / 1e4);
  const std::string what = atoms || result.card ? result.resolved.potential : "membrane";
  return fmt::format("{}, {}, tip radius {:g} Å", what, size, result.resolved.tip_radius_A);
}

}  // namespace

Plot force_depth_plot(const Result& result) {
  Panel panel{.title = title_of(result),
              .x = {.label = "depth", .unit = "Å", .key = "depth_A"},
              .y = {.label = "force", .unit = "eV/Å", .key = "force_eV_per_A"}};
  add_runs(panel, result);
  const double force = largest_force(panel.curves), depth = largest_depth(result);
  panel.x.low = panel.y.low = 0;
  panel.x.high = depth > 0 ? 1.04 * depth : 1;
  panel.y.high = force > 0 ? 1.05 * force : 1;
  panel.legend = legend_place(panel.curves, depth, force);
  add_eq16(panel.curves, result);
  return {.panels = {std::move(panel)}};
}

}  // namespace validate
