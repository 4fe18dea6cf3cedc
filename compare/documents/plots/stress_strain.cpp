#include "compare/documents/plots/stress_strain.hpp"

#include <fmt/format.h>

#include "compare/base/units.hpp"

namespace validate {
namespace {

void add_curves(Panel& panel, const StressCurve& c, double artefact_bond_A, Colour colour) {
  PlotCurve solid{.name = c.direction, .x = {}, .y = {}, .colour = colour, .line = Line{.width = 2}};
  PlotCurve beyond = solid;
  beyond.name += fmt::format(", a bond beyond {} Å", artefact_bond_A);
  beyond.line->dash = Dash::dotted;
  beyond.in_legend = false;
  for (std::size_t k = 0; k < c.strain.size(); ++k) {
    const bool inside = c.longest_bond_A[k] < artefact_bond_A;
    if (!inside && beyond.x.empty() && !solid.x.empty()) {  // without a gap between them
      beyond.x.push_back(solid.x.back());
      beyond.y.push_back(solid.y.back());
    }
    PlotCurve& curve = inside && beyond.x.empty() ? solid : beyond;
    curve.x.push_back(100 * c.strain[k]);
    curve.y.push_back(c.stress_eV_per_A2[k] * N_per_m_per_eV_per_A2);
  }
  panel.curves.push_back(std::move(solid));
  if (!beyond.x.empty()) panel.curves.push_back(std::move(beyond));
}

}  // namespace

Plot stress_strain_plot(const Result& result) {
  const PotentialSummary& potential = result.potential;
  Panel panel{.title = fmt::format("{}: homogeneous strain at T = 0 (dotted: a bond beyond {} Å)", potential.name,
                                   potential.artefact_bond_A),
              .x = {.label = "nominal strain", .unit = "%", .key = "strain_percent", .low = 0},
              .y = {.label = "nominal stress", .unit = "N/m", .key = "stress_N_per_m", .low = 0},
              .legend = Legend::right_bottom};
  for (std::size_t i = 0; i < result.stress_curves.size(); ++i)
    add_curves(panel, result.stress_curves[i], potential.artefact_bond_A, nth_colour(i));
  return {.panels = {std::move(panel)}, .width = 900, .height = 620};
}

}  // namespace validate
