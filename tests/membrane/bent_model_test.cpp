// The sheet that bends, asked for as any other: every load, against the one-dimensional sheet and the plate.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <numbers>
#include <sstream>

#include "membrane/problem.hpp"
#include "membrane/triangles/model.hpp"
#include "taylor.hpp"

namespace membrane::testing {
namespace {

using std::numbers::pi;

/// Coefficients of data/airebo_law.csv, see data/README.md.
CauchyBorn airebo() {
  std::ifstream file(MEMBRANE_TEST_DATA "/airebo_law.csv");
  std::string line;
  std::getline(file, line);
  CauchyBorn law;
  char comma = 0;
  std::getline(file, line);
  std::istringstream(line) >> law.sheet_modulus_eV_per_A2 >> comma >> law.nu;
  while (std::getline(file, line)) {
    InvariantTerm term;
    std::istringstream(line) >> term.a >> comma >> term.b >> comma >> term.coefficient_eV_per_A2;
    law.terms.push_back(term);
  }
  EXPECT_EQ(law.terms.size(), 18u);
  return law;
}

constexpr double kappa = 0.967;
/// AIREBO's lattice; 110 Å to the first held atom; the area of the 126 atoms within 10 Å as a disc.
const double bond = 2.41924328 / std::numbers::sqrt3;
const double a = 110 + 0.75 * bond;
const double c = std::sqrt(126 * 0.75 * std::numbers::sqrt3 * bond * bond / pi);

Problem bent_sheet(Load load, std::vector<double> levels) {
  Problem problem;
  problem.sheet = DiscSheet{.radius_A = a};
  problem.law = airebo();
  problem.relaxed = false;
  problem.bending = clamped_all_round(kappa);
  problem.load = std::move(load);
  problem.levels = std::move(levels);
  problem.record_radius_A = bond;
  return problem;
}

Problem its_twin(Problem problem) {
  problem.discretisation = Meridian{};
  return problem;
}

std::vector<Step> run(const Problem& problem) {
  std::vector<Step> steps;
  const Report report = solve(problem, [&](const Step& step) {
    steps.push_back(step);
    return true;
  });
  EXPECT_TRUE(report.converged) << report.reason;
  std::cout << report.elements << " elements, " << steps.size() << " levels: " << report.factorisations
            << " factorisations, " << report.cuts.size() << " cuts\n";
  for (const auto& cut : report.cuts) std::cout << "  " << cut << '\n';
  return steps;
}

void expect_same_forces(const Problem& problem, double tolerance) {
  const auto steps = run(problem);
  const auto twins = run(its_twin(problem));
  ASSERT_EQ(steps.size(), twins.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double excess = steps[i].force_eV_per_A / twins[i].force_eV_per_A - 1;
    std::cout << "depth " << problem.levels[i] << ": " << excess << " in force, "
              << steps[i].depth_A / twins[i].depth_A - 1 << " in depth of record\n";
    EXPECT_LE(std::abs(excess), tolerance) << problem.levels[i];
    EXPECT_LE(std::abs(steps[i].depth_A / twins[i].depth_A - 1), tolerance) << problem.levels[i];
    // Deeper, the curvature per reference length differs from the surface's by a stretch that shows.
    const double deep = problem.levels[i] <= 12 ? 0.02 : 0.15;
    EXPECT_NEAR(steps[i].bending_energy_eV / twins[i].bending_energy_eV, 1, deep) << problem.levels[i];
    EXPECT_NEAR(steps[i].energy_eV / twins[i].energy_eV, 1, 2 * tolerance) << problem.levels[i];
  }
}

// From bending alone (depth/R = 0.005) to where AIREBO's bonds reach their switch (0.29).
TEST(BentSheet, UnderADiscIsTheOneDimensionalSheet) {
  expect_same_forces(bent_sheet(DiscLoad{c}, {0.5, 2, 4, 8, 12, 16, 20, 24, 28, 32}), 1.5e-3);
}

TEST(BentSheet, UnderAPointIsTheOneDimensionalSheet) { expect_same_forces(bent_sheet(PointLoad{}, {1, 4, 8}), 0.003); }

// Contact ends somewhere within a ring, which at 4 Å is a third of its radius.
TEST(BentSheet, UnderASphereIsTheOneDimensionalSheet) {
  Problem problem = bent_sheet(SphereLoad{30}, {4, 8, 16});
  expect_same_forces(problem, 0.01);
}

// At 5e-3 eV/Å³ the rim's layer is 0.7 Å, half a ring: the volume errs by 0.6 %, and by 0.1 % with 144 rings.
TEST(BentSheet, UnderPressureIsTheOneDimensionalSheet) {
  Problem problem = bent_sheet(PressureLoad{}, {1e-5, 1e-4, 1e-3, 5e-3});
  problem.control = Control::force;
  const auto steps = run(problem);
  const auto twins = run(its_twin(problem));
  ASSERT_EQ(steps.size(), twins.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    std::cout << "pressure " << problem.levels[i] << ": " << steps[i].depth_A / twins[i].depth_A - 1 << '\n';
    EXPECT_NEAR(steps[i].depth_A / twins[i].depth_A, 1, 3e-3);
    EXPECT_NEAR(steps[i].volume_A3 / twins[i].volume_A3, 1, 7e-3);
  }
}

// A plate at small deflection: F = 16 π κ δ/a², and a disc's centre depth (4a² − 4c² ln(a/c) − 3c²)/(64πκ)
// per force (Timoshenko & Woinowsky-Krieger, Theory of Plates and Shells, art. 19).
TEST(BentSheet, AtSmallDepthIsTheClampedPlate) {
  for (double tip : {0.0, c}) {
    const double compliance = tip == 0
                                  ? a * a / (16 * pi * kappa)
                                  : (4 * a * a - 4 * tip * tip * std::log(a / tip) - 3 * tip * tip) / (64 * pi * kappa);
    Problem problem = bent_sheet(tip == 0 ? Load(PointLoad{}) : Load(DiscLoad{tip}), {1e-3});
    problem.record_radius_A = 0;
    const Step step = run(problem).back();
    const double excess = step.force_eV_per_A * compliance / step.depth_A - 1;
    std::cout << "plate under a tip of " << tip << " Å: " << excess << " in force\n";
    EXPECT_LE(std::abs(excess), 0.005);
    EXPECT_GT(step.bending_energy_eV, 0.999 * step.energy_eV);
  }
}

// By force as by depth; a path's energy is the work along it.
TEST(BentSheet, GoesByForceToo) {
  Problem problem = bent_sheet(DiscLoad{c}, {8});
  std::get<DiscSheet>(problem.sheet).rings = 32;
  const Step by_depth = run(problem).back();
  problem.control = Control::force;
  problem.levels = {0.1 * by_depth.force_eV_per_A, by_depth.force_eV_per_A};
  const Step by_force = run(problem).back();
  EXPECT_NEAR(by_force.conjugate_depth_A, 8, 1e-5);
  EXPECT_NEAR(by_force.energy_eV, by_depth.energy_eV, 1e-5 * by_depth.energy_eV);
  EXPECT_NEAR(by_depth.support_force_eV_per_A.z(), by_depth.force_eV_per_A, 1e-6 * by_depth.force_eV_per_A);
}

/// Over all degrees of freedom that are not held, at a state where every term acts.
void expect_consistent(const Problem& problem, double pressure) {
  Model model(problem);
  TotalEnergy& total = model.energy();
  model.set_pressure(pressure);
  Eigen::VectorXd u =
      Eigen::VectorXd::NullaryExpr(total.dof_count(), [](Eigen::Index i) { return 0.3 * std::sin(3.7 * i); });
  Eigen::VectorXd v = Eigen::VectorXd::NullaryExpr(u.size(), [](Eigen::Index i) { return std::cos(1.3 * i * i); });
  for (int n = 0; n < model.mesh().node_count(); ++n) u[3 * n + 2] -= 8 * (1 - model.mesh().nodes[n].norm() / a);
  if (std::holds_alternative<SphereLoad>(problem.load)) u[model.indenter_dof()] = -9;
  total.release_held(u);
  total.release_held(v);
  Eigen::VectorXd gradient, other;
  const double energy = total.energy(u, gradient);
  const Eigen::VectorXd Kv = total.hessian(u).selfadjointView<Eigen::Lower>() * v;
  for (const Obstacle* obstacle : model.obstacles()) EXPECT_GT(obstacle->penetration(u), 0.1);
  EXPECT_GT(model.bending_energy(u), 0.1);
  expect_order([&](double t) { return std::abs(total.energy(u + t * v, other) - energy - t * gradient.dot(v)); }, 1e-4,
               2, 1e-12 * energy);
  expect_order(
      [&](double t) {
        total.energy(u + t * v, other);
        Eigen::VectorXd difference = other - gradient - t * Kv;
        total.release_held(difference);
        return difference.norm();
      },
      1e-4, 2, 1e-12 * gradient.norm());
}

TEST(BentSheet, TheWholeModelsHessianIsThatOfItsEnergy) {
  for (const Load& load : {Load(PointLoad{}), Load(DiscLoad{c}), Load(SphereLoad{30})})
    for (Extent extent : {Extent::quarter, Extent::full}) {
      Problem problem = bent_sheet(load, {1});
      problem.sheet = DiscSheet{.radius_A = a, .rings = 10, .extent = extent};
      expect_consistent(problem, 1e-3);
    }
}

// A square whose edges slide, some free: rotations of free edges, symmetry planes of a quarter.
TEST(BentSheet, AQuarterOfASquareIsTheSquare) {
  const auto depth = [](Extent extent, int cells) {
    Problem problem = bent_sheet(PressureLoad{}, {2e-4});
    problem.control = Control::force;
    problem.record_radius_A = 0;
    problem.bending = BendingModuli{kappa, -0.7};
    problem.sheet = RectangleSheet{.length_x_A = 60,
                                   .length_y_A = 60,
                                   .cells_x = cells,
                                   .cells_y = cells,
                                   .extent = extent,
                                   .left = Support::clamped,
                                   .right = Support::clamped};
    const Step step = run(problem).back();
    return step.depth_A;
  };
  const double quarter = depth(Extent::quarter, 10);
  EXPECT_NEAR(depth(Extent::full, 20), quarter, 1e-6 * quarter);
}

TEST(BentSheet, RefusesToBeRelaxedAndUnstableModuli) {
  const auto refused = [](auto spoil) {
    Problem bad = bent_sheet(DiscLoad{c}, {1});
    spoil(bad);
    EXPECT_THROW(check(bad), std::invalid_argument);
  };
  EXPECT_NO_THROW(check(bent_sheet(DiscLoad{c}, {1})));
  refused([](Problem& p) { p.relaxed = true; });
  refused([](Problem& p) { p.bending->mean_eV = 0; });
  refused([](Problem& p) { p.bending->gaussian_eV = 0; });
  refused([](Problem& p) { p.bending->gaussian_eV = -2 * kappa; });
}

}  // namespace
}  // namespace membrane::testing
