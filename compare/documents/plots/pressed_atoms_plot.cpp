#include "compare/documents/plots/pressed_atoms_plot.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace validate {
namespace {

std::vector<PlotCurve> both(double point_size) {
  return {{.name = "membrane", .x = {}, .y = {}, .colour = colour_of_membrane, .line = Line{}},
          {.name = "atoms", .x = {}, .y = {}, .colour = colour_of_atoms, .points = Points{.size = point_size}}};
}

const Run* pressed(const Result& result, Model model) {
  const auto found = std::ranges::find_if(
      result.runs, [&](const Run& run) { return run.load == LoadKind::pressure && run.model == model; });
  return found == result.runs.end() || found->cross_section.x_A.empty() ? nullptr : &*found;
}

Panel depth_panel(const Run& membrane, const Run& atoms) {
  Panel panel{.title = "depth of the centre",
              .x = {.label = "pressure", .unit = "eV/Å³", .key = "pressure_eV_per_A3", .logarithmic = true},
              .y = {.label = "depth", .unit = "Å", .key = "depth_A", .logarithmic = true},
              .legend = Legend::left_top,
              .curves = both(0.8)};
  panel.curves[0].x = membrane.pressure_eV_per_A3, panel.curves[0].y = membrane.depth_A;
  panel.curves[1].x = atoms.pressure_eV_per_A3, panel.curves[1].y = atoms.depth_A;
  return panel;
}

Panel section_panel(const Run& membrane, const Run& atoms) {
  Panel panel{.title = fmt::format("cross-section at {:.4g} eV/Å³", atoms.pressure_eV_per_A3.back()),
              .x = {.label = "x", .unit = "Å", .key = "x_A"},
              .y = {.label = "z", .unit = "Å", .key = "z_A", .high = 0},
              .legend = Legend::centre_top,
              .curves = both(0.35)};
  panel.curves[0].x = membrane.cross_section.x_A, panel.curves[0].y = membrane.cross_section.z_A;
  panel.curves[1].x = atoms.cross_section.x_A, panel.curves[1].y = atoms.cross_section.z_A;
  return panel;
}

}  // namespace

Plot pressed_atoms_plot(const Result& result) {
  const Run *membrane = pressed(result, Model::membrane), *atoms = pressed(result, Model::atomistic);
  if (!membrane || !atoms) return {};
  Plot plot{.width = 700, .height = 380};
  if (atoms->depth_A.size() > 1) {
    plot.panels.push_back(depth_panel(*membrane, *atoms));
    plot.width = 1000;
  }
  plot.panels.push_back(section_panel(*membrane, *atoms));
  plot.columns = static_cast<int>(plot.panels.size());
  return plot;
}

}  // namespace validate
