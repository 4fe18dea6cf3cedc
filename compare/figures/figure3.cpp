// Figure 3: larger principal Cauchy stress on the paper's mesh, point and disc load, where the rim reads
// 0.125 eV/Å³.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "compare/base/paper.hpp"
#include "compare/documents/plots/sheet_maps.hpp"
#include "compare/figures/paper_figure.hpp"
#include "compare/figures/square.hpp"
#include "compare/fitting/curve.hpp"

namespace validate {
namespace {

constexpr double rim_stress = 0.125, tip_stress = 0.65;  // of its colour bar, eV/Å³
const membrane::StVenantKirchhoff law{paper::Eh_eV_per_A2, paper::nu};

struct Reading {
  double force = 0, rim = 0, largest = 0;
};

membrane::Problem problem_of(const membrane::Load& load, std::vector<double> forces) {
  membrane::Problem problem;
  problem.sheet = membrane::paper_disc(paper::radius_A);
  problem.law = law;
  problem.load = load;
  problem.control = membrane::Control::force;
  problem.levels = std::move(forces);
  return problem;
}

const std::vector<double>& stress(const SheetPicture& sheet) { return column(sheet.triangles, "cauchy_1_eV_per_A3"); }

double rim_mean(const SheetPicture& sheet) {
  double sum = 0;
  for (const int t : sheet.mesh.rim_triangles) sum += stress(sheet)[static_cast<std::size_t>(t)];
  return sum / static_cast<double>(sheet.mesh.rim_triangles.size());
}

/// The force at which the rim's mean is the paper's reading.
double force_for_the_rim(const membrane::Load& load) {
  const std::vector<double> forces = {1, 2, 4, 7, 11, 16, 22, 29, 37};
  std::vector<double> rim;
  for (const SheetPicture& sheet : solved_levels(problem_of(load, forces), paper::thickness_A, "figure 3"))
    rim.push_back(rim_mean(sheet));
  const auto force = Curve(rim, forces).at(rim_stress);
  if (!force) throw std::runtime_error("figure 3: the rim does not reach its stress");
  return *force;
}

void add(PaperFigure& figure, const char* name, const membrane::Load& load, const FigureContext& context) {
  context.progress.say(fmt::format("figure 3: {}", name));
  const double force = force_for_the_rim(load);
  const membrane::Problem problem = problem_of(load, {force / 8, force / 3, force});
  const SheetPicture sheet = solved_levels(problem, paper::thickness_A, "figure 3").back();
  TriangleMap map = recovered_map(sheet, name, "cauchy_1_eV_per_A3", SeenOver::flat);
  map.key = "larger_principal_stress_eV_per_A3";
  map.quarter = false;  // as the paper shows it
  Panel panel{.title = fmt::format("{}, F = {:.2f} eV/Å", name, force),
              .x = {.label = "x", .unit = "Å", .key = "x_A", .low = 0, .high = 112},
              .y = {.label = "y", .unit = "Å", .key = "y_A", .low = 0, .high = 112},
              .equal_axes = true,
              .maps = {std::move(map)},
              .scale = {.label = "eV/Å³", .low = rim_stress, .high = tip_stress}};
  figure.panels.push_back(std::move(panel));
  const double tip = std::ranges::max(stress(sheet));
  const bool reproduces = std::abs(tip / tip_stress - 1) < 0.2;
  figure.numbers.push_back({fmt::format("{}: stress at the rim", name), "eV/Å³", "Gil et al. 2010, Figure 3",
                            rim_stress, rim_mean(sheet), 0.01, "the load is chosen so"});
  figure.numbers.push_back({fmt::format("{}: largest stress", name), "eV/Å³", "Gil et al. 2010, Figure 3", tip_stress,
                            tip, 0,
                            fmt::format("the {} {} the published range 0.125 … 0.65 eV/Å³", name,
                                        reproduces ? "reproduces" : "does not reproduce")});
}

}  // namespace

PaperFigure figure3(const FigureContext& context) {
  PaperFigure figure;
  figure.number = 3;
  figure.title = "larger principal Cauchy stress, 1936 triangles, rim at 0.125 eV/Å³";
  add(figure, "point load", membrane::PointLoad{}, context);
  add(figure, "disc of 10 Å", membrane::DiscLoad{paper::tip_A}, context);
  return figure;
}

}  // namespace validate
