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

/// Short strokes along the larger stress in wrinkled triangles, every few of them: the rays of the tension
/// field.
PlotCurve rays(const Square& square) {
  constexpr double length_A = 5, spacing_A = 8;
  PlotCurve curve{.name = "tension rays", .x = {}, .y = {}, .line = Line{.width = 0.7}, .strokes = true};
  std::vector<Eigen::Vector2d> drawn;
  for (const TriangleStress& t : square.field) {
    if (t.state != membrane::SheetState::wrinkled) continue;
    const Eigen::Vector2d middle = (t.corners_A[0] + t.corners_A[1] + t.corners_A[2]) / 3;
    if (std::ranges::any_of(drawn, [&](const Eigen::Vector2d& d) { return (d - middle).norm() < spacing_A; })) continue;
    drawn.push_back(middle);
    for (const double end : {-0.5, 0.5}) {
      curve.x.push_back(middle[0] + end * length_A * t.direction[0]);
      curve.y.push_back(middle[1] + end * length_A * t.direction[1]);
    }
  }
  return curve;
}

void add_numbers(PaperFigure& figure, const Square& square) {
  double largest_of_smaller = 0;
  for (const TriangleStress& t : square.field) largest_of_smaller = std::max(largest_of_smaller, t.smaller_eV_per_A3);
  figure.numbers.push_back({"smaller principal stress: upper end", "eV/Å³", "Gil et al. 2010, Figure 4", 0.045,
                            largest_of_smaller, 0.05, "the published colour bar ends at 0.045"});
  figure.numbers.push_back({"centre depth", "Å", "finite elements written separately, 7200 triangles on the full plate",
                            56.34, square.centre_depth_A, 2e-3, "cells are cut along other diagonals there"});
  figure.numbers.push_back({"wrinkled share of the area", "1",
                            "finite elements written separately, 0.57 to 0.71 by mesh and path", 0.64,
                            square.wrinkled_share, 0.15, "depends on mesh and path"});
  figure.numbers.push_back({"mid-side pull-in", "Å", "finite elements written separately, 32 to 36 by mesh and path",
                            34, square.pull_in_A, 0.1, "depends on mesh and path"});
}

}  // namespace

PaperFigure figure4(const FigureContext& context) {
  context.progress.say("figure 4: pressurised square");
  const Square square = solve_square(paper_problem(), paper::thickness_A);
  PaperFigure figure;
  figure.number = 4;
  figure.title = "square of 220 Å under 5.16529e-4 eV/Å³, edges in their plane, 7200 triangles";
  figure.panels.push_back(square_panel("smaller principal Cauchy stress", "eV/Å³", "smaller_principal_stress_eV_per_A3",
                                       square, [](const TriangleStress& t) { return t.smaller_eV_per_A3; }));
  figure.panels.back().scale.low = 0, figure.panels.back().scale.high = 0.045;  // the paper's
  figure.panels.push_back(square_panel("larger principal Cauchy stress", "eV/Å³", "larger_principal_stress_eV_per_A3",
                                       square, [](const TriangleStress& t) { return t.larger_eV_per_A3; }));
  figure.panels.back().scale.low = 0;
  figure.panels.push_back(square_panel("states and tension rays", "", "state", square, [](const TriangleStress& t) {
    return t.state == membrane::SheetState::slack ? 0.0 : t.state == membrane::SheetState::wrinkled ? 1.0 : 2.0;
  }));
  figure.panels.back().scale = scale_of_states();
  std::ranges::reverse(figure.panels.back().scale.classes);  // from slack to taut, as the stress grows
  figure.panels.back().curves.push_back(rays(square));
  add_numbers(figure, square);
  if (context.atoms) add_square_of_atoms(figure, context);
  return figure;
}

}  // namespace validate
