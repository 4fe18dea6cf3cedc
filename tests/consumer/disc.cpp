// A clamped disc under a force at its centre, solved with the installed library on a meridian and on triangles.
//
// For nu = 1/3 the force is known in closed form at any depth: F = (pi/3) E·h d³/a² (E. Schwerin, Z. angew. Math. Mech.
// 9 (1929) 482). The meridian errs by less than 1e-6, 72 rings of triangles by 0.1 %.
#include <cmath>
#include <cstdio>
#include <numbers>

#include "membrane/problem.hpp"

namespace {

constexpr double radius_A = 110, modulus_eV_per_A2 = 8, depth_A = 11;

bool agrees(const char* name, membrane::Discretisation discretisation, double tolerance) {
  membrane::Problem problem;
  problem.discretisation = discretisation;
  problem.sheet = membrane::DiscSheet{radius_A};
  problem.law = membrane::make_law("svk", {{"Eh", modulus_eV_per_A2}, {"nu", 1.0 / 3}});
  problem.load = membrane::PointLoad{};
  problem.levels = {depth_A};
  double force = std::nan("");
  const membrane::Report report = membrane::solve(problem, [&](const membrane::Step& step) {
    force = step.force_eV_per_A;
    return true;
  });
  const double exact = std::numbers::pi / 3 * modulus_eV_per_A2 * std::pow(depth_A, 3) / (radius_A * radius_A);
  std::printf("%s: %.9f eV/A, exactly %.9f (%s)\n", name, force, exact, report.reason.c_str());
  return report.converged && std::abs(force / exact - 1) < tolerance;
}

}  // namespace

int main() {
  const bool meridian = agrees("meridian", membrane::Meridian{}, 1e-6);
  const bool triangles = agrees("triangles", membrane::Triangles{}, 2e-3);
  return meridian && triangles ? 0 : 1;
}
