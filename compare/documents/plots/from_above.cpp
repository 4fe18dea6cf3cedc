#include "compare/documents/plots/from_above.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "compare/base/units.hpp"
#include "compare/documents/plots/sheet_maps.hpp"

namespace validate {
namespace {

Panel atoms_panel(LoadKind load, const std::vector<AtomFromAbove>& atoms) {
  PlotCurve curve{.name = "longest_bond_A", .x = {}, .y = {}};
  curve.points = Points{.size = std::clamp(55 / std::sqrt(static_cast<double>(atoms.size())), 0.12, 0.8)};
  double size = 0;
  for (const AtomFromAbove& atom : atoms) {
    curve.x.push_back(atom.x_A);
    curve.y.push_back(atom.y_A);
    curve.value.push_back(atom.longest_bond_A);
    size = std::max({size, std::abs(atom.x_A), std::abs(atom.y_A)});
  }
  Panel panel = seen_from_above(fmt::format("atoms, {} load: longest bond", load), size);
  panel.curves = {std::move(curve)};
  panel.scale.label = "Å";
  return panel;
}

void leave_out_within(double radius_A, TriangleMap& map) {
  TriangleMap kept = map;
  kept.corners.clear(), kept.value.clear(), kept.at_corners.clear();
  for (std::size_t i = 0; i < map.value.size(); ++i) {
    const auto& c = map.corners[i];
    if ((c[0] + c[1] + c[2]).norm() / 3 < radius_A) continue;
    kept.corners.push_back(c);
    kept.value.push_back(map.value[i]);
    kept.at_corners.push_back(map.at_corners[i]);
  }
  map = std::move(kept);
}

Panel membrane_panel(const Run& run, const SheetPicture& picture) {
  TriangleMap map = recovered_map(picture, "larger principal force", "cauchy_1_eV_per_A3");
  map.key = "larger_principal_force_N_per_m";
  const double factor = picture.thickness_A * N_per_m_per_eV_per_A2;
  for (double& value : map.value) value *= factor;
  for (auto& values : map.at_corners)
    for (double& value : values) value *= factor;
  if (!(run.tip_A > 0)) leave_out_within(0.01 * run.a_A, map);
  Panel panel = seen_from_above(fmt::format("membrane, {} load: larger Cauchy force", run.load), run.a_A);
  panel.maps = {std::move(map)};
  panel.scale.label = "N/m";
  return panel;
}

}  // namespace

Plot from_above_plot(LoadKind load, const std::vector<AtomFromAbove>& atoms, const Run* membrane) {
  Plot plot;
  if (!atoms.empty()) plot.panels.push_back(atoms_panel(load, atoms));
  const auto* pictures = membrane ? membrane->continuum().pictures.get() : nullptr;
  if (pictures && !pictures->empty()) plot.panels.push_back(membrane_panel(*membrane, pictures->back()));
  plot.columns = static_cast<int>(plot.panels.size());
  plot.width = 550 * plot.columns, plot.height = 500;
  return plot;
}

}  // namespace validate
