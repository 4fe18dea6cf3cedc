#include "compare/documents/plots/from_above.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compare/base/units.hpp"
#include "compare/documents/plots/sheet_maps.hpp"

namespace validate {
namespace {

Panel atoms_panel(const std::string& load, const std::vector<AtomFromAbove>& atoms) {
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

/// Rings cut into triangles, over one quarter of the disc.
TriangleMap map_of(const RoundField& field) {
  constexpr int sectors = 18;
  TriangleMap map{
      .name = "membrane", .key = "larger_principal_force_N_per_m", .corners = {}, .value = {}, .quarter = true};
  const auto at = [&](std::size_t circle, int k) {
    const double angle = std::numbers::pi / 2 * k / sectors;
    return Eigen::Vector2d(field.radius_A[circle] * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  };
  for (std::size_t i = 1; i < field.radius_A.size(); ++i) {
    if (field.tip_A <= 0 && field.radius_A[i - 1] < 0.01 * field.radius_A.back()) continue;
    const double mean = (field.larger_force_eV_per_A2[i - 1] + field.larger_force_eV_per_A2[i]) / 2;
    for (int k = 0; k < sectors; ++k) {
      map.corners.push_back({at(i - 1, k), at(i, k), at(i, k + 1)});
      map.corners.push_back({at(i - 1, k), at(i, k + 1), at(i - 1, k + 1)});
      map.value.insert(map.value.end(), 2, N_per_m_per_eV_per_A2 * mean);
    }
  }
  return map;
}

Panel membrane_panel(const RoundField& field) {
  Panel panel =
      seen_from_above(fmt::format("membrane, {} load: larger Cauchy force", field.load), field.radius_A.back());
  panel.maps = {map_of(field)};
  panel.scale.label = "N/m";
  return panel;
}

}  // namespace

Plot from_above_plot(const std::string& load, const std::vector<AtomFromAbove>& atoms,
                     const std::optional<RoundField>& membrane) {
  Plot plot;
  if (!atoms.empty()) plot.panels.push_back(atoms_panel(load, atoms));
  if (membrane && membrane->radius_A.size() > 1) plot.panels.push_back(membrane_panel(*membrane));
  plot.columns = static_cast<int>(plot.panels.size());
  plot.width = 550 * plot.columns, plot.height = 500;
  return plot;
}

}  // namespace validate
