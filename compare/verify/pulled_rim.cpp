// Wrinkles that change the force: a disc whose rim slides under a dead tension.
#include "compare/results/pulled_rim.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "compare/verify/groups.hpp"
#include "compare/verify/solved.hpp"

namespace validate::verify {
namespace {

using namespace membrane;

/// The constants of the separate solution.
constexpr double radius_A = 200, modulus = 17.33, nu = 0.3645, tension = 1e-3 * modulus;

Problem pulled(double tip_over_radius, int rings) {
  Problem problem = round_sheet(radius_A, modulus, nu, rings);
  std::get<DiscSheet>(problem.sheet).rim = Support::sliding;
  problem.edge_tension_eV_per_A2 = tension;
  problem.load = DiscLoad{tip_over_radius * radius_A};
  return problem;
}

Problem on_meridian(double tip_over_radius, bool relaxed) {
  Problem problem = pulled(tip_over_radius, DiscSheet{}.rings);
  problem.discretisation = Meridian{2};
  problem.relaxed = relaxed;
  return problem;
}

/// At a depth of the centre, found by the secant of two conjugate depths.
Step at_centre_depth(Problem problem, double depth_relative) {
  const double aim = depth_relative * radius_A;
  problem.levels = {0.96 * aim, 0.98 * aim};
  const std::vector<Step> near = solved(problem);
  const double share = (aim - near[0].depth_A) / (near[1].depth_A - near[0].depth_A);
  problem.levels = {std::lerp(0.96 * aim, 0.98 * aim, share)};
  return solved_last(problem);
}

double over_cone(const Step& step) { return step.force_eV_per_A / cone_of_a_point(tension, step.depth_A); }

/// The depths at which a curve of its own, one-dimensional, was printed to three decimals.
void separate_solution(Ledger& ledger) {
  constexpr double share = 1.0 / 11;
  const std::pair<double, double> known[] = {{0.10, 1.001}, {0.14, 1.043}, {0.15, 1.048}, {0.19, 1.064}};
  const auto origin = [](double value) { return separate_code(value, "1-D tension field, three decimals"); };
  for (const auto& [depth, factor] : known) {
    ledger.begin(fmt::format("rim under 1e-3 E h, c = a/11, {} a deep", depth));
    ledger.equal("F/(2 pi T d), one dimension", over_cone(at_centre_depth(on_meridian(share, true), depth)),
                 origin(factor), 0.003);
    ledger.equal("F/(2 pi T d), 48 rings of triangles", over_cone(at_centre_depth(pulled(share, 48), depth)),
                 origin(factor), 0.003);
  }
  const auto area = [&](double depth) {
    return at_centre_depth(on_meridian(share, true), depth).tautness.wrinkled_area_fraction;
  };
  ledger.begin("rim under 1e-3 E h, c = a/11, where it wrinkles");
  ledger.at_most("wrinkled area, 0.055 a deep", area(0.055), separate_code(0, "taut before the onset"));
  ledger.at_least("wrinkled area, 0.075 a deep", area(0.075), separate_code(0.2, "wrinkled after the onset"));
  ledger.equal("wrinkled area, 0.10 a deep", area(0.10), separate_code(0.88, "two decimals"), 0.01);
  ledger.equal("wrinkled area, 0.14 a deep", area(0.14), separate_code(0.97, "two decimals"), 0.01);
  const auto force = [&](bool relaxed) {
    Problem problem = on_meridian(share, relaxed);
    problem.levels = {0.15 * radius_A};
    return solved_last(problem).force_eV_per_A;
  };
  ledger.equal("force borne with compression / relieved, 0.15 a of conjugate depth", force(false) / force(true),
               separate_code(1.9, "one decimal"), 0.03);
}

/// Taut as long as the depth is next to nothing: what stretching adds is of second order in it.
void shallow(Ledger& ledger) {
  for (const double share : {0.02, 1.0 / 11}) {
    Problem problem = on_meridian(share, true);
    problem.levels = {1e-4 * radius_A};
    ledger.begin(fmt::format("rim under tension, 1e-4 a deep, c = {:.4f} a", share));
    ledger.equal("F/(2 pi T d)", over_cone(solved_last(problem)), closed_form(taut_factor(share), "1/(ln(a/c) + 1/2)"),
                 2e-3);
  }
}

/// Wrinkled all over: from (δ/a)² >> T/E·h on. The less a sheet stretches, the nearer it is to the cone.
void cone(Ledger& ledger) {
  for (const double share : {0.02, 1.0 / 11}) {
    Problem problem = on_meridian(share, true);
    problem.edge_tension_eV_per_A2 = 1e-6 * modulus;
    problem.levels = {0.04 * radius_A};
    const Step step = solved_last(problem);
    const double force = step.force_eV_per_A / cone_of_a_point(1e-6 * modulus, step.depth_A);
    ledger.begin(fmt::format("rim under 1e-6 E h, 0.04 a deep, c = {:.4f} a", share));
    ledger.equal("F/(2 pi T d)", force, closed_form(cone_factor(share), "1/(1 - 2c/3a)"), 0.01);
  }
}

/// Without a load: λ S = T, S of Hooke's law at the Green–Lagrange strain.
void flat(Ledger& ledger) {
  Problem problem = pulled(1.0 / 11, 24);
  problem.levels = {1e-5};
  double strain = 0;
  for (int i = 0; i < 50; ++i) strain = tension * (1 - nu) / modulus / std::sqrt(1 + 2 * strain);
  ledger.begin("flat disc under edge tension, 24 rings");
  const Step step = solved_last(problem);
  ledger.equal("least membrane force, eV/A^2", step.tautness.least_force_eV_per_A2,
               closed_form(strain * modulus / (1 - nu), "Lame: E h e/(1 - nu), stretch times it = T"), 1e-6);
  ledger.equal("rim displacement, A", step.rim_displacement_A,
               closed_form(radius_A * (std::sqrt(1 + 2 * strain) - 1), "a (stretch - 1)"), 1e-6);
}

}  // namespace

void verify_pulled_rim(Ledger& ledger) {
  flat(ledger);
  shallow(ledger);
  separate_solution(ledger);
  cone(ledger);
}

}  // namespace validate::verify
