// Figure 3: larger principal Cauchy stress on the paper's mesh, point and disc load, where the rim reads
// 0.125 eV/Å³.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "compare/base/paper.hpp"
#include "compare/figures/paper_figure.hpp"
#include "compare/figures/stress_field.hpp"
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

double rim_mean(const membrane::Mesh& mesh, const std::vector<TriangleStress>& field) {
  double sum = 0;
  for (const int t : mesh.rim_triangles) sum += field[static_cast<std::size_t>(t)].larger_eV_per_A3;
  return sum / static_cast<double>(mesh.rim_triangles.size());
}

/// Fields at each force.
std::vector<std::vector<TriangleStress>> fields(const membrane::Problem& problem) {
  const membrane::Mesh mesh = membrane::mesh_of(problem);
  std::vector<std::vector<TriangleStress>> all;
  const membrane::Report report = membrane::solve(problem, [&](const membrane::Step& step) {
    if (step.converged)
      all.push_back(stress_field(problem, mesh, paper::thickness_A, step.on_triangles().displacements));
    return step.converged;
  });
  if (!report.converged) throw std::runtime_error("figure 3: " + report.reason);
  return all;
}

/// The force at which the rim's mean is the paper's reading.
double force_for_the_rim(const membrane::Load& load) {
  const std::vector<double> forces = {1, 2, 4, 7, 11, 16, 22, 29, 37};
  const membrane::Problem problem = problem_of(load, forces);
  const membrane::Mesh mesh = membrane::mesh_of(problem);
  std::vector<double> rim;
  for (const auto& field : fields(problem)) rim.push_back(rim_mean(mesh, field));
  const auto force = Curve(rim, forces).at(rim_stress);
  if (!force) throw std::runtime_error("figure 3: the rim does not reach its stress");
  return *force;
}

double largest(const std::vector<TriangleStress>& field) {
  return std::ranges::max_element(field, {}, &TriangleStress::larger_eV_per_A3)->larger_eV_per_A3;
}

TriangleMap map_of(const std::string& name, const std::vector<TriangleStress>& field) {
  TriangleMap map{.name = name, .key = "larger_principal_stress_eV_per_A3", .corners = {}, .value = {}};
  for (const TriangleStress& t : field) {
    map.corners.push_back(t.corners_A);
    map.value.push_back(t.larger_eV_per_A3);
  }
  return map;
}

void add(PaperFigure& figure, const char* name, const membrane::Load& load, const FigureContext& context) {
  context.progress.say(fmt::format("figure 3: {}", name));
  const double force = force_for_the_rim(load);
  const membrane::Problem problem = problem_of(load, {force / 8, force / 3, force});
  const std::vector<TriangleStress> field = fields(problem).back();
  Panel panel{.title = fmt::format("{}, F = {:.2f} eV/Å", name, force),
              .x = {.label = "x", .unit = "Å", .key = "x_A", .low = 0, .high = 112},
              .y = {.label = "y", .unit = "Å", .key = "y_A", .low = 0, .high = 112},
              .equal_axes = true,
              .maps = {map_of(name, field)},
              .scale = {.label = "eV/Å³", .low = rim_stress, .high = tip_stress}};
  figure.panels.push_back(std::move(panel));
  const double tip = largest(field);
  const bool reproduces = std::abs(tip / tip_stress - 1) < 0.2;
  figure.numbers.push_back({fmt::format("{}: stress at the rim", name), "eV/Å³", "Gil et al. 2010, Figure 3",
                            rim_stress, rim_mean(membrane::mesh_of(problem), field), 0.01, "the load is chosen so"});
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
