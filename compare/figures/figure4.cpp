// Figure 4: a square under pressure whose edges are held in their plane but free to slide.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include "compare/figures/paper_figure.hpp"
#include "compare/figures/stress_field.hpp"

namespace compare {
namespace {

constexpr double side_A = 220, thickness_A = 1.37, pressure_eV_per_A3 = 5.16529e-4;  // the paper's
const membrane::StVenantKirchhoff law{5.864 * thickness_A, 0.19};

struct Square {
  membrane::Mesh mesh;
  std::vector<TriangleStress> field;
  double centre_depth_A = 0, pull_in_A = 0;
};

/// How far the middle of an edge has moved inwards, at most.
double pull_in(const membrane::Mesh& mesh, const Eigen::VectorXd& u) {
  double largest = 0;
  for (const auto& [edge, nodes] : mesh.edges)
    for (const int n : nodes) {
      const Eigen::Vector2d place = mesh.nodes[static_cast<std::size_t>(n)];
      const int across = edge == membrane::Edge::left || edge == membrane::Edge::right ? 0 : 1;
      largest = std::max(largest, -u[3 * n + across] * (place[across] > 0 ? 1 : -1));
    }
  return largest;
}

Square solve_square() {
  membrane::Problem problem;
  problem.sheet = membrane::paper_square(side_A);
  problem.law = law;
  problem.load = membrane::PressureLoad{};
  problem.control = membrane::Control::force;
  problem.levels = {pressure_eV_per_A3};
  const membrane::Mesh mesh = membrane::mesh_of(problem);
  Square square;
  const membrane::Report report = membrane::solve(problem, [&](const membrane::Step& step) {
    if (!step.converged) return false;
    square.field = stress_field(problem, mesh, thickness_A, step.displacements);
    square.centre_depth_A = step.depth_A;
    square.pull_in_A = pull_in(mesh, step.displacements);
    return true;
  });
  if (!report.converged) throw std::runtime_error("figure 4: " + report.reason);
  square.mesh = mesh;
  return square;
}

/// The sides between a wrinkled triangle and one that is not, and those of wrinkled triangles on the edge of
/// the sheet.
FigureCurve outline(const Square& square) {
  FigureCurve curve{.name = "wrinkled zone",
                    .x = {},
                    .y = {},
                    .y_high = {},
                    .style = "lines lc rgb 'white' lw 1",
                    .broken = true};
  std::map<std::pair<int, int>, int> wrinkled_sides;  // how many wrinkled triangles a side has
  for (std::size_t i = 0; i < square.field.size(); ++i) {
    if (square.field[i].state != membrane::SheetState::wrinkled) continue;
    const auto& n = square.mesh.triangles[i].nodes;
    for (int a = 0; a < 3; ++a)
      ++wrinkled_sides[std::pair(std::min(n[a], n[(a + 1) % 3]), std::max(n[a], n[(a + 1) % 3]))];
  }
  for (const auto& [side, count] : wrinkled_sides) {
    if (count != 1) continue;
    for (const int node : {side.first, side.second}) {
      curve.x.push_back(square.mesh.nodes[static_cast<std::size_t>(node)][0]);
      curve.y.push_back(square.mesh.nodes[static_cast<std::size_t>(node)][1]);
    }
  }
  return curve;
}

FigurePanel panel(const char* title, const char* label, const char* key, const Square& square,
                  double (*value)(const TriangleStress&)) {
  FigurePanel p{
      .title = title,
      .x_label = "x (Å)",
      .y_label = "y (Å)",
      .x_key = "x_A",
      .y_key = "y_A",
      .settings = fmt::format("set xrange [-112:112]\nset yrange [-112:112]\nset cblabel '{}'\n", label),
      .curves = {},
      .fields = {}};
  FigureField map{.name = title, .key = key, .corners_A = {}, .value = {}};
  for (const TriangleStress& t : square.field) {
    map.corners_A.push_back(t.corners_A);
    map.value.push_back(value(t));
  }
  p.fields.push_back(std::move(map));
  p.curves.push_back(outline(square));
  return p;
}

/// Short strokes along the larger stress in wrinkled triangles, every few of them: the rays of the tension
/// field.
FigureCurve rays(const Square& square) {
  constexpr double length_A = 5, spacing_A = 8;
  FigureCurve curve{.name = "tension rays",
                    .x = {},
                    .y = {},
                    .y_high = {},
                    .style = "lines lc rgb 'black' lw 0.7",
                    .broken = true};
  std::vector<Eigen::Vector2d> drawn;
  for (const TriangleStress& t : square.field) {
    if (t.state != membrane::SheetState::wrinkled) continue;
    const Eigen::Vector2d middle = (t.corners_A[0] + t.corners_A[1] + t.corners_A[2]) / 3;
    if (std::ranges::any_of(drawn, [&](const Eigen::Vector2d& d) { return (d - middle).norm() < spacing_A; }))
      continue;
    drawn.push_back(middle);
    for (const double end : {-0.5, 0.5}) {
      curve.x.push_back(middle[0] + end * length_A * t.direction[0]);
      curve.y.push_back(middle[1] + end * length_A * t.direction[1]);
    }
  }
  return curve;
}

void add_numbers(PaperFigure& figure, const Square& square) {
  double wrinkled = 0, all = 0, largest_of_smaller = 0;
  for (std::size_t i = 0; i < square.field.size(); ++i) {
    all += square.mesh.triangles[i].area_A2;
    if (square.field[i].state == membrane::SheetState::wrinkled) wrinkled += square.mesh.triangles[i].area_A2;
    largest_of_smaller = std::max(largest_of_smaller, square.field[i].smaller_eV_per_A3);
  }
  figure.numbers.push_back({"smaller principal stress: upper end", "eV/Å³", "Gil et al. 2010, Figure 4",
                            0.045, largest_of_smaller, 0.05, "the published colour bar ends at 0.045"});
  figure.numbers.push_back({"centre depth", "Å",
                            "finite elements written separately, 7200 triangles on the full plate", 56.34,
                            square.centre_depth_A, 2e-3, "cells are cut along other diagonals there"});
  figure.numbers.push_back({"wrinkled share of the area", "1",
                            "finite elements written separately, 0.57 to 0.71 by mesh and path", 0.64,
                            wrinkled / all, 0.15, "depends on mesh and path"});
  figure.numbers.push_back({"mid-side pull-in", "Å",
                            "finite elements written separately, 32 to 36 by mesh and path", 34,
                            square.pull_in_A, 0.1, "depends on mesh and path"});
}

}  // namespace

PaperFigure figure4(const FigureContext& context) {
  context.progress.say("figure 4: pressurised square");
  const Square square = solve_square();
  PaperFigure figure{.number = 4,
                     .title = "square of 220 Å under 5.16529e-4 eV/Å³, edges in their plane, 7200 triangles",
                     .panels = {},
                     .numbers = {}};
  figure.panels.push_back(panel("smaller principal Cauchy stress", "eV/Å³",
                                "smaller_principal_stress_eV_per_A3", square,
                                [](const TriangleStress& t) { return t.smaller_eV_per_A3; }));
  figure.panels.back().settings += "set cbrange [0:0.045]\n";  // the paper's
  figure.panels.push_back(panel("larger principal Cauchy stress", "eV/Å³",
                                "larger_principal_stress_eV_per_A3", square,
                                [](const TriangleStress& t) { return t.larger_eV_per_A3; }));
  figure.panels.push_back(
      panel("states and tension rays", "state", "state", square, [](const TriangleStress& t) {
        return t.state == membrane::SheetState::slack      ? 0.0
               : t.state == membrane::SheetState::wrinkled ? 1.0
                                                           : 2.0;
      }));
  figure.panels.back().settings +=
      "set cbrange [-0.5:2.5]\nset cbtics ('slack' 0, 'wrinkled' 1, 'taut' 2)\nset palette defined (0 "
      "'#dddddd', 1 '#E69F00', 2 '#56B4E9') maxcolors 3\n";
  figure.panels.back().curves.push_back(rays(square));
  add_numbers(figure, square);
  return figure;
}

}  // namespace compare
