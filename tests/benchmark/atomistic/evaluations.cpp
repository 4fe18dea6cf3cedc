// Force evaluations per depth, for potentials × radii × loads: steps of R/55 from 0.02 to 0.2 of the radius at
// max|f| <= 1e-5 eV/Å. Averages leave out the first depth and the artefact zone.
//
//   atomistic_evaluations [POTENTIAL[,…]|all] [RADIUS_A[,…]] [LOAD[,…]]        exit code 1 if a limit is exceeded
#include <fmt/format.h>

#include <cstdio>
#include <string>

#include "tests/benchmark/atomistic/support.hpp"

namespace {

using namespace atomistic;
using namespace benchmark_support;

/// Averages that every potential must keep; tersoff-1989's band under hoop compression costs it more.
double limit_of(const std::string& potential) { return potential == "tersoff-1989" ? 12 : 9; }
constexpr int first_depth_limit = 20;

bool report(const std::string& name, const Problem& problem, const std::string& load, const MpiSession& session) {
  const Path path = follow(problem, session);
  double evaluations = 0, depths = 0;
  int factorisations = 0;
  for (std::size_t i = 1; i < path.steps.size(); ++i) {
    const Step& step = path.steps[i];
    factorisations += step.factorisations;
    if (step.longest_bond_A >= problem.potential.artefact_bond_A - 0.02) continue;
    evaluations += step.evaluations, ++depths;
  }
  const double average = evaluations / depths;
  const int first = path.steps.front().evaluations;
  const bool good = path.steps.back().converged && average <= limit_of(name) && first <= first_depth_limit;
  const Report& r = path.report;
  fmt::print("{:14} {:5.0f} {:9} {:8} {:6} {:6.0f} {:8.2f} {:5} {:7.1f} {:7.1f} {:7.1f} {:7.1f}  {}{}\n", name,
             problem.radius_A, load, path.atoms, first, depths, average, factorisations, r.force_s, r.setup_s,
             r.factor_s, r.solve_s, name_of(r.ended), good ? "" : "  ABOVE THE LIMIT");
  std::fflush(stdout);
  return good;
}

}  // namespace

int main(int argc, char** argv) {
  const MpiSession session(&argc, &argv);
  const auto words = [&](int k, const char* otherwise) { return split(argc > k ? argv[k] : otherwise); };
  bool good = true;
  fmt::print(
      "potential      R (Å) load         atoms  first depths  average  fact. force s setup s fact. s solve s  ended\n");
  for (const std::string& name : words(1, "all") == split("all") ? shipped_potentials() : words(1, "all"))
    for (const std::string& radius : words(2, "30,110"))
      for (const std::string& load : words(3, "point,disc"))
        good = report(name, disc_problem(name, std::stod(radius), load), load, session) && good;
  return good ? 0 : 1;
}
