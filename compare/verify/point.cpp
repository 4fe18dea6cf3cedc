// Point load at the centre of a clamped disc.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "compare/verify/groups.hpp"
#include "compare/verify/solved.hpp"

namespace validate::verify {
namespace {

using namespace membrane;
using std::numbers::pi;

constexpr double a = 110;
constexpr double Eh = 8;
constexpr int rings = 36;  // of the coarser mesh of a pair
const std::string meshes = "36 and 72 graded rings";

Problem point(double nu, int count, double depth) {
  Problem problem = round_sheet(a, Eh, nu, count);
  problem.load = PointLoad{};
  problem.levels = {depth};
  return problem;
}

double alpha(const Problem& problem) {
  const Step step = solved_last(problem);
  return step.force_eV_per_A * a * a / (Eh * std::pow(step.depth_A, 3));
}

MeshPair alphas(double nu, double depth) {
  return {alpha(point(nu, rings, depth)), alpha(point(nu, 2 * rings, depth)), meshes};
}

void exact_at_any_depth(Ledger& ledger) {
  for (const double ratio : {0.01, 0.1, 0.3}) {
    ledger.begin(fmt::format("nu = 1/3, depth {} a", ratio));
    ledger.converging("F a^2/(Eh d^3)", alphas(1.0 / 3, ratio * a),
                      closed_form(pi / 3, "F = (pi/3) Eh d^3/a^2, finite strain (Schwerin 1929)"), 2, 0.01);
  }
}

void poisson(Ledger& ledger) {
  for (const char* nu : {"0", "0.165", "0.19", "0.3"}) {
    ledger.begin(fmt::format("alpha at nu = {}, depth 0.005 a", nu));
    ledger.converging("F a^2/(Eh d^3)", alphas(std::stod(nu), 0.005 * a),
                      tabulated(fmt::format("point_alpha.nu_{}", nu)), 2, 0.01);
  }
}

/// dF/dN0 at N0 = 0 over pi d, by a centred difference. At small slopes: 0.05 a deep, finite strain changes it by 2e-4
/// if nu = 0.
double beta(double nu, int count) {
  constexpr double depth = 0.01 * a, small = 4e-7 * Eh;
  const auto force = [&](double pretension) {
    Problem problem = point(nu, count, depth);
    problem.prestress_eV_per_A2 = isotropic(pretension);
    return solved_last(problem).force_eV_per_A;
  };
  return (force(small) - force(-small)) / (2 * small * pi * depth);
}

void pretension(Ledger& ledger) {
  for (const auto& [nu, name] :
       {std::pair{0.0, "nu_0"}, {0.165, "nu_0.165"}, {0.19, "nu_0.19"}, {0.3, "nu_0.3"}, {1.0 / 3, "nu_1/3"}}) {
    ledger.begin(fmt::format("beta at nu = {:.3g}", nu));
    ledger.converging("dF/dN0/(pi d)", {beta(nu, rings), beta(nu, 2 * rings), meshes},
                      tabulated(fmt::format("point_beta.{}", name)), 2, 0.01);
  }
}

/// Depth at the force of depth 0.1 a over that depth: what a mesh makes of the point.
double relative_depth(int count, RingSpacing spacing) {
  Problem problem = point(1.0 / 3, count, 0.1 * a);
  std::get<DiscSheet>(problem.sheet).spacing = spacing;
  problem.control = Control::force;
  problem.levels = {pi / 3 * Eh * 1e-3 * a};
  return solved_last(problem).depth_A / (0.1 * a);
}

void mesh_table(Ledger& ledger) {
  const Reference exact = closed_form(1, "d = a (3 F/(pi Eh a))^(1/3) at nu = 1/3");
  for (const auto& [spacing, name, order] :
       {std::tuple{RingSpacing::uniform, "uniform", 2.0 / 3}, {RingSpacing::graded, "graded", 2.0}}) {
    double before = 0;
    for (const int count : {11, 22, 44, 88}) {
      const double error = 1 - relative_depth(count, spacing);
      ledger.begin(fmt::format("{} rings, {}", count, name));
      const double bound = spacing == RingSpacing::uniform ? 0.03 * std::pow(44.0 / count, order)
                                                           : 0.002 * std::pow(44.0 / count, order);
      ledger.equal("depth under a given force / exact", 1 - error, exact, bound,
                   fmt::format("{:.2f} % too shallow", 100 * error));
      if (before != 0 && count == 88)
        ledger.equal("observed order", std::log2(before / error),
                     identity(order, "h^(2/3) where elements have one size, h^2 graded"), 0.15);
      before = error;
    }
  }
}

}  // namespace

void verify_point(Ledger& ledger) {
  exact_at_any_depth(ledger);
  poisson(ledger);
  pretension(ledger);
  mesh_table(ledger);
}

}  // namespace validate::verify
