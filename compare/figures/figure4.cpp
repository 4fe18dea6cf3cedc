// Figure 4: a square under pressure whose edges are held in their plane but free to slide.
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "compare/base/paper.hpp"
#include "compare/documents/plots/sheet_maps.hpp"
#include "compare/figures/paper_figure.hpp"
#include "compare/figures/square.hpp"
#include "compare/figures/square_of_atoms.hpp"

namespace validate {
namespace {

membrane::Problem paper_problem() {
  membrane::Problem problem;
  problem.sheet = membrane::paper_square(paper::side_A);
  problem.law = membrane::StVenantKirchhoff{paper::Eh_eV_per_A2, paper::nu};
  problem.load = membrane::PressureLoad{};
  problem.control = membrane::Control::force;
  problem.levels = {paper::pressure_eV_per_A3};
  return problem;
}

/// The square as it stands under the pressure, in the colours of its larger stress.
Panel oblique_panel(const SheetPicture& square) {
  Panel panel = square_panel("the deformed square, larger stress", "eV/Å³", square, "cauchy_1_eV_per_A3",
                             "larger_principal_stress_eV_per_A3");
  raise(panel.maps[0], square);
  panel.curves.clear();
  panel.scale.low = 0;
  return panel;
}

void add_numbers(PaperFigure& figure, const SheetPicture& square) {
  figure.numbers.push_back({"smaller principal stress: upper end", "eV/Å³", "Gil et al. 2010, Figure 4", 0.045,
                            std::ranges::max(column(square.triangles, "cauchy_2_eV_per_A3")), 0.05,
                            "the published colour bar ends at 0.045"});
  figure.numbers.push_back({"centre depth", "Å", "finite elements written separately, 7200 triangles on the full plate",
                            56.34, total(square.totals, "depth_A"), 2e-3, "cells are cut along other diagonals there"});
  figure.numbers.push_back({"wrinkled share of the area", "1",
                            "finite elements written separately, 0.57 to 0.71 by mesh and path", 0.64,
                            total(square.totals, "wrinkled_area_fraction"), 0.15, "depends on mesh and path"});
  figure.numbers.push_back({"mid-side pull-in", "Å", "finite elements written separately, 32 to 36 by mesh and path",
                            34, largest_pull_in_A(square), 0.1, "depends on mesh and path"});
}

}  // namespace

PaperFigure figure4(const FigureContext& context) {
  context.progress.say("figure 4: pressurised square");
  const SheetPicture square = solved_levels(paper_problem(), paper::thickness_A, "figure 4").back();
  PaperFigure figure;
  figure.number = 4;
  figure.title = "square of 220 Å under 5.16529e-4 eV/Å³, edges in their plane, 7200 triangles";
  figure.panels = {square_panel("smaller principal Cauchy stress", "eV/Å³", square, "cauchy_2_eV_per_A3",
                                "smaller_principal_stress_eV_per_A3"),
                   square_panel("larger principal Cauchy stress", "eV/Å³", square, "cauchy_1_eV_per_A3",
                                "larger_principal_stress_eV_per_A3"),
                   square_panel("states and tension rays", "", square, "state", "state")};
  figure.panels[0].scale.low = figure.panels[1].scale.low = 0;
  figure.panels[0].scale.high = 0.045;  // the paper's
  Panel& states = figure.panels[2];
  for (double& state : states.maps[0].value) state = 2 - state;  // from slack to taut, as the stress grows
  states.scale = scale_of_states();
  std::ranges::reverse(states.scale.classes);
  states.curves.push_back(tension_rays(square, SeenOver::deformed));
  figure.panels.push_back(oblique_panel(square));
  add_numbers(figure, square);
  if (context.atoms) add_square_of_atoms(figure, context);
  return figure;
}

}  // namespace validate
