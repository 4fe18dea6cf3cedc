#include "compare/documents/plots/force_depth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "compare/documents/plots/residual_panel.hpp"
#include "compare/documents/sentences/shown_units.hpp"
#include "compare/documents/sentences/verdict_text.hpp"
#include "compare/fitting/curve.hpp"
#include "compare/fitting/models/eq16.hpp"

namespace validate {

namespace {

constexpr int pieces = 200;  // of a smooth curve

std::vector<LoadKind> loads_of(const Result& result) {
  std::vector<LoadKind> loads;
  for (const Run& run : result.runs)
    if (run.load != LoadKind::pressure && std::ranges::find(loads, run.load) == loads.end()) loads.push_back(run.load);
  if (loads.empty()) loads.push_back(result.resolved.judged_load);  // axes without curves
  return loads;
}

/// A curve with the word that stands at its end.
struct NamedCurve {
  PlotCurve curve;
  std::string word = {};
  bool computed = true;  ///< not a closed form, which may leave the panel
};

/// The curves of one load, in the units that are shown.
class LoadCurves {
 public:
  LoadCurves(const Result& result, LoadKind load) : result_(result), load_(load), shown_(shown_units(result.resolved)) {
    for (const Run& run : result.runs)
      if (run.load == load && !run.is_atomistic()) add_continuum(run);
    add_eq16();
    for (const Run& run : result.runs)  // upon the lines
      if (run.load == load && run.is_atomistic()) add_atoms(run);
  }

  Panel panel() const;

 private:
  void add_point(PlotCurve& curve, double depth_A, double force_eV_per_A) const {
    curve.x.push_back(shown_.length.of(depth_A));
    curve.y.push_back(shown_.force.of(force_eV_per_A));
  }
  void add_smooth_points(PlotCurve& smooth, const Run& run) const;
  void add_continuum(const Run& run);
  void add_atoms(const Run& run);
  void add_eq16();
  double deepest_A() const;
  void name_ends(Panel& panel) const;

  const Result& result_;
  LoadKind load_;
  ShownUnits shown_;
  std::vector<NamedCurve> curves_;
};

/// Through the computed points as the comparison interpolates them. It starts at the first of them: nothing is known
/// below.
void LoadCurves::add_smooth_points(PlotCurve& smooth, const Run& run) const {
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
void LoadCurves::add_continuum(const Run& run) {
  if (usable_points(run).size() < 2) return;
  const bool sheet = run.model == Model::sheet, paper = run.constants == Constants::paper;
  if (!sheet && run.constants == Constants::calibrated) return;
  PlotCurve curve{.name = sheet ? std::string("sheet: own law, bending")
                                : fmt::format("membrane{}, {} constants", law_of(run), *run.constants),
                  .x = {},
                  .y = {},
                  .colour = sheet   ? colour_of_membrane
                            : paper ? Colour::purple
                                    : Colour::green,
                  .line = Line{sheet   ? Dash::solid
                               : paper ? Dash::dashed
                                       : Dash::long_dash_dotted,
                               sheet ? 2.6 : 1.5}};
  add_smooth_points(curve, run);
  curves_.push_back({std::move(curve), sheet ? "sheet" : paper ? "paper" : "membrane"});
}

void LoadCurves::add_atoms(const Run& run) {
  Points points{.marker = load_ == LoadKind::disc ? Marker::square : Marker::circle, .size = 1};
  PlotCurve usable{.name = "atoms", .x = {}, .y = {}, .colour = colour_of_atoms};
  usable.points = points;
  for (const std::size_t i : usable_points(run)) add_point(usable, run.depth_A[i], run.force_eV_per_A[i]);

  PlotCurve artefact{.name = fmt::format("atoms, bond ≥ {:.2f} Å", artefact_bond_of(result_)),
                     .x = {},
                     .y = {},
                     .colour = colour_of_atoms};
  points.open = true;
  artefact.points = points;
  artefact.in_legend = false;  // the zone that they lie in is
  for (std::size_t i = 0; i < run.depth_A.size(); ++i)
    if (run.atoms().artefact[i] && run.converged[i]) add_point(artefact, run.depth_A[i], run.force_eV_per_A[i]);
  for (PlotCurve* curve : {&usable, &artefact})
    if (!curve->x.empty()) curves_.push_back({std::move(*curve)});
}

double LoadCurves::deepest_A() const {
  double deepest = 0;
  for (const Run& run : result_.runs)
    if (run.load == load_)
      for (const double depth : run.depth_A) deepest = std::max(deepest, depth);
  return deepest;
}

// The closed form with the constants of the like-for-like membrane, or of whatever membrane there is.
void LoadCurves::add_eq16() {
  for (const Constants constants : {Constants::card, Constants::given, Constants::paper}) {
    const auto run = std::ranges::find_if(result_.runs, [&](const Run& r) {
      return r.load == load_ && r.model == Model::membrane && r.constants == constants;
    });
    if (run == result_.runs.end()) continue;
    const Eq16 closed_form{run->a_A, run->nu};
    PlotCurve curve{.name = fmt::format("Eq. 16, {} constants", to_string(constants)),
                    .x = {},
                    .y = {},
                    .line = Line{.width = 0.8}};
    for (int i = 0; i <= pieces; ++i) {
      const double depth = deepest_A() * i / pieces;
      add_point(curve, depth, closed_form.force(depth, run->Eh_eV_per_A2, run->pretension_eV_per_A2));
    }
    curves_.push_back({std::move(curve), "Eq. 16", false});
    return;
  }
}

/// Words at the ends of the lines that come to the panel's right side, moved apart where they would lie on each other.
void LoadCurves::name_ends(Panel& panel) const {
  const double line_height = 0.058 * *panel.y.high;
  for (const auto& [curve, word, computed] : curves_)
    if (!word.empty() && !curve.x.empty() && curve.x.back() > 0.85 * *panel.x.high && curve.y.back() < *panel.y.high)
      panel.labels.push_back({word, curve.x.back(), curve.y.back(), curve.colour});
  std::ranges::sort(panel.labels, {}, &TextLabel::y);
  for (std::size_t i = 1; i < panel.labels.size(); ++i)
    panel.labels[i].y = std::max(panel.labels[i].y, panel.labels[i - 1].y + line_height);
}

Panel LoadCurves::panel() const {
  Panel panel{.title = fmt::format("{} load", load_),
              .x = {.label = "depth", .unit = shown_.length.name, .key = "depth_" + shown_.length.key, .low = 0},
              .y = {.label = "force", .unit = shown_.force.name, .key = "force_" + shown_.force.key, .low = 0}};
  double highest = 0;
  for (const NamedCurve& one : curves_) {
    if (one.computed)
      for (const double force : one.curve.y) highest = std::max(highest, force);
    panel.curves.push_back(one.curve);
  }
  const double deepest = shown_.length.of(deepest_A());
  panel.x.high = deepest > 0 ? 1.04 * deepest : 1;
  panel.y.high = highest > 0 ? 1.05 * highest : 1;
  for (const Run& run : result_.runs)
    if (const auto first = first_artefact(run); run.load == load_ && first)
      panel.zones.push_back({.from = shown_.length.of(run.depth_A[*first]),
                             .colour = Colour::dark_grey,
                             .name = fmt::format("artefact zone, bond ≥ {:.2f} Å", artefact_bond_of(result_)),
                             .edge = true});
  name_ends(panel);
  return panel;
}

/// Top left, where force curves leave room; the other corner if one passes through there after all.
Legend legend_place(const Panel& panel) {
  for (const PlotCurve& curve : panel.curves)
    for (std::size_t i = 0; i < curve.x.size(); ++i)
      if (curve.x[i] < 0.5 * *panel.x.high && curve.y[i] > 0.6 * *panel.y.high) return Legend::right_bottom;
  return Legend::left_top;
}

std::string title_of(const Result& result) {
  const bool atoms = std::ranges::any_of(result.runs, [](const Run& r) { return r.is_atomistic(); });
  const Case& c = result.resolved;
  const ShownUnit length = shown_units(c).length;
  const std::string what = atoms || result.card ? c.potential : "membrane";
  return fmt::format("{}, R = {}, tip radius {}", what, length.text(c.radius_A), length.text(c.tip_radius_A));
}

std::string caption_of(const Result& result, int width) {
  if (!result.agreement) return {};
  if (width == single_column) return short_verdict(*result.agreement);
  return fmt::format("{}. {} Below: what is left, with 95 % bars; green: the tolerance, dotted: the range judged.",
                     outcome_word(result.agreement->outcome), verdict_sentence(*result.agreement, result.resolved));
}

Plot plot_of(const Result& result, const std::vector<LoadKind>& loads, int width) {
  Plot plot{.title = title_of(result), .width = width, .row_shares = {1}};
  std::vector<Panel> below;
  for (const LoadKind load : loads) {
    plot.panels.push_back(LoadCurves(result, load).panel());
    if (auto panel = residual_panel(result, load, *plot.panels.back().x.high)) below.push_back(std::move(*panel));
  }
  plot.panels.front().legend = legend_place(plot.panels.front());
  plot.columns = static_cast<int>(plot.panels.size());
  plot.right_margin = 66;
  plot.caption = caption_of(result, width);
  if (below.size() == plot.panels.size()) {
    plot.row_shares = {0.66, 0.34};
    for (Panel& panel : below) plot.panels.push_back(std::move(panel));
  }
  plot.height = (plot.row_shares.size() > 1 ? 680 : 480) - (width == single_column ? 80 : 0);
  return plot;
}

}  // namespace

Plot force_depth_plot(const Result& result) { return plot_of(result, loads_of(result), double_column); }

Plot narrow_force_depth_plot(const Result& result) {
  const std::vector<LoadKind> loads = loads_of(result);
  const LoadKind judged = result.resolved.judged_load;
  const bool there = std::ranges::find(loads, judged) != loads.end();
  return plot_of(result, {there ? judged : loads.front()}, single_column);
}

}  // namespace validate
