#include "compare/verify/strip.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/verify/solved.hpp"
#include "membrane/laws/tension_field.hpp"
#include "membrane/terms/stretching.hpp"

namespace validate::verify {
namespace {

using namespace membrane;

constexpr double Eh = 8;
constexpr double length = 40;
constexpr double width = 40;

/// What a strip answers to the uniform curvature that belongs to one M/(PH).
struct BentStrip {
  double moment_over_force = 0;  ///< M/(PH), from the reactions of the moved edge
  double band = 0;               ///< share of the middle half that is not taut
};

/// Both ends clamped and moved as an even strip's would: strain κ (y − y0) with y0 the border of the band.
/// With nu = 0 the clamps do not disturb it. The strain is small: 2e-4 at most.
Problem bent(double band, int cells) {
  const double kappa = 2e-4 / (width * (1 - band)), border = width * (band - 0.5);
  Problem problem;
  problem.sheet = RectangleSheet{.length_x_A = length,
                                 .length_y_A = width,
                                 .cells_x = cells,
                                 .cells_y = cells,
                                 .extent = Extent::full,
                                 .left = Support::clamped,
                                 .right = Support::clamped,
                                 .bottom = Support::free,
                                 .top = Support::free};
  problem.law = StVenantKirchhoff{Eh, 0};
  problem.load = EdgeMotion{.edge = Edge::right,
                            .translation_A = {-kappa * border * length, -kappa * length * length / 2, 0},
                            .pivot_A = {length / 2, 0},
                            .rotation_rad = -kappa * length};
  problem.levels = {1};
  return problem;
}

double band_of(const Problem& problem, const Step& step) {
  const Mesh mesh = mesh_of(problem);
  const auto force = [&](const Triangle& triangle) {
    return principal_forces(membrane_force({problem.law, Voigt::Zero(), true},
                                           strain_of(triangle, step.on_triangles().displacements)))
        .larger;
  };
  const auto in_middle = [&](const Triangle& triangle) {
    double x = 0;
    for (const int node : triangle.nodes) x += mesh.nodes[node].x() / 3;
    return std::abs(x) < length / 4;
  };
  double largest = 0, area = 0, idle = 0;
  for (const Triangle& triangle : mesh.triangles) largest = std::max(largest, force(triangle));
  for (const Triangle& triangle : mesh.triangles) {
    if (!in_middle(triangle)) continue;
    area += triangle.area_A2;
    if (force(triangle) < 1e-3 * largest) idle += triangle.area_A2;
  }
  return idle / area;
}

BentStrip answer(double band, int cells) {
  const Problem problem = bent(band, cells);
  const Step step = solved_last(problem);
  const double P = step.edge_force_eV_per_A.x(), M = -step.edge_torque_eV;
  return {M / (P * width), band_of(problem, step)};
}

}  // namespace

void verify_bent_strip(Ledger& ledger) {
  constexpr int cells = 20;
  for (const char* ratio : {"0.2", "0.3", "0.4"}) {
    const Reference band = tabulated(fmt::format("bent_strip_band.M_{}PH", ratio));
    const BentStrip coarse = answer(band.value, cells), fine = answer(band.value, 2 * cells);
    ledger.begin(fmt::format("strip in bending, M = {} PH, nu = 0", ratio));
    ledger.converging("M/(PH)", {coarse.moment_over_force, fine.moment_over_force, "20 x 20 and 40 x 40 x 2 triangles"},
                      {std::stod(ratio), band.origin}, 2, 0.03);
    ledger.equal(
        "band/H", fine.band,
        closed_form(3 * fine.moment_over_force - 0.5, "3M/(PH) - 1/2 (Stein & Hedgepeth 1961), M and P measured"),
        0.5 / (2 * cells) / (3 * fine.moment_over_force - 0.5), "by the states of triangles: half a row of cells");
  }
}

}  // namespace validate::verify
