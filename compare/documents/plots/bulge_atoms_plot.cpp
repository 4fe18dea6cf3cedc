#include "compare/documents/plots/bulge_atoms_plot.hpp"

#include <fmt/format.h>

#include <cmath>

namespace validate {
namespace {

std::vector<PlotCurve> both(double point_size) {
  return {{.name = "membrane", .x = {}, .y = {}, .colour = colour_of_membrane, .line = Line{}},
          {.name = "atoms", .x = {}, .y = {}, .colour = colour_of_atoms, .points = Points{.size = point_size}}};
}

Panel depth_panel(const BulgeAtoms& atoms) {
  Panel panel{.title = "depth of the centre",
              .x = {.label = "pressure", .unit = "eV/Å³", .key = "pressure_eV_per_A3", .logarithmic = true},
              .y = {.label = "depth", .unit = "Å", .key = "depth_A", .logarithmic = true},
              .legend = Legend::left_top,
              .curves = both(0.8)};
  for (const BulgeAtomsPoint& p : atoms.points) {
    if (!std::isfinite(p.membrane_depth_A)) continue;
    for (PlotCurve& curve : panel.curves) curve.x.push_back(p.pressure_eV_per_A3);
    panel.curves[0].y.push_back(p.membrane_depth_A);
    panel.curves[1].y.push_back(p.depth_A);
  }
  return panel;
}

Panel profile_panel(const BulgeAtoms& atoms) {
  Panel panel{.title = fmt::format("cross-section at {:.4g} eV/Å³", atoms.points.back().pressure_eV_per_A3),
              .x = {.label = "x", .unit = "Å", .key = "x_A"},
              .y = {.label = "z", .unit = "Å", .key = "z_A", .high = 0},
              .legend = Legend::centre_top,
              .curves = both(0.35)};
  panel.curves[0].x = atoms.membrane_profile.x_A;
  panel.curves[0].y = atoms.membrane_profile.z_A;
  panel.curves[1].x = atoms.atoms_profile.x_A;
  panel.curves[1].y = atoms.atoms_profile.z_A;
  return panel;
}

}  // namespace

Plot bulge_atoms_plot(const BulgeAtoms& atoms) {
  if (atoms.points.empty() || atoms.membrane_profile.x_A.empty()) return {};
  Plot plot{.width = 700, .height = 380};
  if (atoms.points.size() > 1) {
    plot.panels.push_back(depth_panel(atoms));
    plot.width = 1000;
  }
  plot.panels.push_back(profile_panel(atoms));
  plot.columns = static_cast<int>(plot.panels.size());
  return plot;
}

}  // namespace validate
