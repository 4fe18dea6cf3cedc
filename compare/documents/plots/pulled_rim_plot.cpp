#include "compare/documents/plots/pulled_rim_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/base/units.hpp"
#include "compare/results/pulled_rim.hpp"

namespace validate {
namespace {

PlotCurve styled(const Run& run, std::string name) {
  PlotCurve curve{.name = std::move(name), .x = {}, .y = {}};
  const bool borne = run.compression == Compression::borne;
  if (run.model == Model::atomistic) {
    curve.colour = colour_of_atoms;
    curve.points = Points{.size = 0.9};
  } else if (run.model == Model::sheet) {
    curve.colour = nth_colour(2);
    curve.line = Line{borne ? Dash::solid : Dash::dotted, 2};
  } else {
    curve.colour = borne ? Colour::grey : colour_of_membrane;
    const bool own_law = run.constants == Constants::calibrated;
    curve.line = Line{borne ? Dash::dashed : own_law ? Dash::long_dash_dotted : Dash::solid, own_law ? 1.0 : 1.6};
  }
  return curve;
}

PlotCurve force_curve(const Run& run) {
  PlotCurve curve = styled(run, pulled_curve_in_words(run));
  for (const std::size_t i : usable_points(run)) {
    curve.x.push_back(run.depth_A[i] / run.a_A);
    curve.y.push_back(run.force_eV_per_A[i] / cone_of_a_point(run.rim_tension_eV_per_A2, run.depth_A[i]));
  }
  return curve;
}

/// Wrinkled area of a tension field, compressed area of what bears compression.
PlotCurve area_curve(const Run& run) {
  PlotCurve curve = styled(run, pulled_curve_in_words(run));
  const auto* part = std::get_if<ContinuumPart>(&run.part);
  if (!part) return curve;
  const auto& shares =
      run.compression == Compression::relieved ? part->wrinkled_area_fraction : part->compressed_area_fraction;
  for (const std::size_t i : usable_points(run)) {
    curve.x.push_back(run.depth_A[i] / run.a_A);
    curve.y.push_back(100 * shares[i]);
  }
  return curve;
}

/// Half of crest to trough, where waves are looked for.
PlotCurve height_curve(const Run& run) {
  PlotCurve curve = styled(run, pulled_curve_in_words(run));
  if (run.wrinkle_count.empty()) return curve;
  for (const std::size_t i : usable_points(run)) {
    curve.x.push_back(run.depth_A[i] / run.a_A);
    curve.y.push_back(run.wrinkle_amplitude_A[i]);
  }
  const int waves = run.wrinkle_count[usable_points(run).back()];
  if (waves > 0) curve.name += fmt::format(": {} at the end", waves);
  return curve;
}

PlotCurve level(const std::string& name, double height, double end, Dash dash) {
  return {.name = name, .x = {0, end}, .y = {height, height}, .line = Line{dash, 0.8}};
}

std::string title_of(const Run& run) {
  return fmt::format("a = {:.4g} Å, rim slides under {:.3g} N/m = {:.2g} E·h, {} of {:.3g} Å", run.a_A,
                     run.rim_tension_eV_per_A2 * N_per_m_per_eV_per_A2, run.rim_tension_eV_per_A2 / run.Eh_eV_per_A2,
                     run.load, run.tip_A);
}

}  // namespace

Plot pulled_rim_plot(const Result& result) {
  const auto first = std::ranges::find_if(result.runs, [](const Run& run) { return has_pulled_rim(run); });
  if (first == result.runs.end()) return {};
  Panel force{.title = title_of(*first),
              .x = {.label = "depth / a", .key = "depth_relative", .low = 0},
              .y = {.label = "force / 2πTδ", .key = "force_relative", .low = 0},
              .legend = Legend::left_top};
  Panel area{.title = "share of the area",
             .x = {.label = "depth / a", .key = "depth_relative", .low = 0},
             .y = {.label = "wrinkled (tension field), compressed (others)",
                   .unit = "%",
                   .key = "area_percent",
                   .low = 0,
                   .high = 100}};
  Panel height{.title = "waves around the axis",
               .x = {.label = "depth / a", .key = "depth_relative", .low = 0},
               .y = {.label = "amplitude", .unit = "Å", .key = "wrinkle_amplitude_A", .low = 0},
               .legend = Legend::left_top};
  double end = 0;
  for (const Run& run : result.runs) {
    if (!has_pulled_rim(run) || run.load != first->load) continue;
    force.curves.push_back(force_curve(run));
    if (auto curve = area_curve(run); !curve.x.empty()) area.curves.push_back(std::move(curve));
    if (auto curve = height_curve(run); !curve.x.empty()) height.curves.push_back(std::move(curve));
    for (const double x : force.curves.back().x) end = std::max(end, x);
  }
  if (first->load != LoadKind::sphere && first->tip_A > 0) {
    const double share = first->tip_A / first->a_A;
    force.curves.push_back(level("wrinkled all over, 1/(1 - 2c/3a)", cone_factor(share), end, Dash::dash_dotted));
    force.curves.push_back(level("taut and shallow, 1/(ln(a/c) + 1/2)", taut_factor(share), end, Dash::dotted));
  }
  Plot plot{.panels = {std::move(force), std::move(area)}, .columns = 1, .width = 800, .height = 900};
  if (height.curves.empty()) return plot;
  plot.panels.push_back(std::move(height));
  plot.height = 1300;
  return plot;
}

}  // namespace validate
