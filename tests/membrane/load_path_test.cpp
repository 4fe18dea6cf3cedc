// solve() against closed forms and an independent one-dimensional solver.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include "solved_path.hpp"

namespace membrane {
namespace {

using std::numbers::pi;
using testing::disc_problem;
using testing::solved_path;

/// Rows of data/case2_disc10.csv: centre depth, force, membrane force at the rim.
std::vector<std::array<double, 3>> case2() {
  std::ifstream file(MEMBRANE_TEST_DATA "/case2_disc10.csv");
  std::string line;
  std::getline(file, line);
  std::vector<std::array<double, 3>> rows;
  for (char comma; std::getline(file, line);) {
    std::istringstream text(line);
    auto& row = rows.emplace_back();
    text >> row[0] >> comma >> row[1] >> comma >> row[2];
  }
  return rows;
}

TEST(Path, PaperDiscOf10) {
  // Origin: 1-D axisymmetric finite St Venant–Kirchhoff, 6 digits. Required within 0.2 %; the mesh's error
  // falls as h² and is 0.05 % in force with 72 rings, so that 0.06 % catches a loss of accuracy.
  const auto reference = case2();
  ASSERT_EQ(reference.size(), 12u);
  std::vector<double> forces;
  for (const auto& row : reference) forces.push_back(row[1]);
  Problem problem = disc_problem(5.864 * 1.37, 0.19, DiscLoad{10}, forces);
  problem.control = Control::force;
  for (const Step& step : solved_path(problem)) {
    const auto& [depth, force, rim] = reference[step.level];
    const double slope = 3;  // d log F / d log depth, to compare forces at equal depth
    EXPECT_NEAR(1 + slope * (depth / step.depth_A - 1), 1, 6e-4) << "depth " << depth;
    EXPECT_NEAR(step.force_eV_per_A, force, 1e-9 * force);
    // The rim's triangles see the force in the middle of the last ring, where it is larger.
    EXPECT_NEAR(step.rim_membrane_force_eV_per_A2 / rim, 1.01, 0.01) << "depth " << depth;
  }
}

TEST(Path, PaperDiscConvergesWithTheSquareOfTheMesh) {
  const auto reference = case2();
  const auto error = [&](int rings) {
    Problem problem = disc_problem(5.864 * 1.37, 0.19, DiscLoad{10}, {reference[5][1]});
    problem.control = Control::force;
    std::get<DiscSheet>(problem.sheet).rings = rings;
    return reference[5][0] / solved_path(problem).at(0).depth_A - 1;
  };
  EXPECT_NEAR(std::log2(error(24) / error(48)), 2, 0.25);
}

TEST(Path, PointLoadIsSchwerins) {
  // nu = 1/3: F = (π/3) E·h δ³/a², exact for finite St Venant–Kirchhoff at any depth. Required within 0.3 %.
  const double modulus = 8;
  for (const Step& step : solved_path(disc_problem(modulus, 1.0 / 3, PointLoad{}, {1.1, 11, 33}))) {
    const double exact = pi / 3 * modulus * std::pow(step.depth_A, 3) / (110.0 * 110.0);
    EXPECT_NEAR(step.force_eV_per_A / exact, 1, 1.2e-3);
    EXPECT_EQ(step.depth_A, step.conjugate_depth_A);
  }
}

TEST(Path, PointLoadDependsOnPoissonsRatioAsFoepplVonKarman) {
  // F = α E·h δ³/a² at small depth; α from the Föppl–von Kármán equation (1-D, five digits).
  for (const auto& [nu, alpha] : {std::pair{0.0, 0.86099}, {0.165, 0.93770}, {0.19, 0.95155}, {0.3, 1.02206}}) {
    const Step step = solved_path(disc_problem(8, nu, PointLoad{}, {1.1})).at(0);
    EXPECT_NEAR(step.force_eV_per_A * 110 * 110 / (8 * std::pow(1.1, 3)) / alpha, 1, 1.5e-3) << "nu " << nu;
  }
}

TEST(Path, DiscLoadStiffensWithItsRadius) {
  // α of a disc of radius c, nu = 0.19, centre depth, Föppl–von Kármán (1-D).
  for (const auto& [ratio, alpha] : {std::pair{0.01, 1.02773}, {0.05, 1.19889}, {1.0 / 11, 1.35188}}) {
    const Step step = solved_path(disc_problem(8, 0.19, DiscLoad{ratio * 110}, {0.5})).at(0);
    const double found = step.force_eV_per_A * 110 * 110 / (8 * std::pow(step.depth_A, 3));
    EXPECT_NEAR(found / alpha, 1, 1e-3) << "c/a " << ratio;
  }
}

TEST(Path, PretensionGovernsShallowDepths) {
  // Linear membrane: F/δ = 2π N0 / (ln(a/c) + ½) at the centre, ¼ for ½ with the conjugate depth.
  for (double tip : {10.0, 2.2}) {
    Problem problem = disc_problem(8, 0.19, DiscLoad{tip}, {0.01});
    problem.prestress_eV_per_A2 = 0.1 * Eigen::Matrix2d::Identity();
    const Step step = solved_path(problem).at(0);
    const double log = std::log(110 / tip);
    EXPECT_NEAR(step.force_eV_per_A / step.depth_A / (2 * pi * 0.1 / (log + 0.5)), 1, 1e-3);
    EXPECT_NEAR(step.force_eV_per_A / step.conjugate_depth_A / (2 * pi * 0.1 / (log + 0.25)), 1, 1e-3);
  }
}

TEST(Path, PretensionAddsTwoThirdsUnderAPoint) {
  // F = α E·h δ³/a² + β π N0 δ to first order in N0; β(1/3) = 2/3 exactly. A centred difference in N0.
  const double depth = 5.5;
  const auto force = [&](double pretension) {
    Problem problem = disc_problem(8, 1.0 / 3, PointLoad{}, {depth});
    problem.prestress_eV_per_A2 = pretension * Eigen::Matrix2d::Identity();
    return solved_path(problem).at(0).force_eV_per_A;
  };
  const double small = 1e-4;
  EXPECT_NEAR((force(small) - force(-small)) / (2 * small) / (pi * depth), 2.0 / 3, 2e-3);
}

TEST(Path, PrestressMayPointAnywhere) {
  // A round sheet does not know where x is: a turned prestress gives the same curve.
  Eigen::Matrix2d prestress;
  prestress << 0.12, 0, 0, 0.03;
  const Eigen::Matrix2d turn = Eigen::Rotation2D<double>(0.6).toRotationMatrix();
  Problem problem = disc_problem(8, 0.19, DiscLoad{10}, {4, 8});
  std::get<DiscSheet>(problem.sheet).rings = 32;
  problem.prestress_eV_per_A2 = prestress;
  const auto straight = solved_path(problem);
  problem.prestress_eV_per_A2 = turn * prestress * turn.transpose();
  problem.prestress_eV_per_A2(1, 0) = problem.prestress_eV_per_A2(0, 1);
  const auto turned = solved_path(problem);
  for (int i : {0, 1}) EXPECT_NEAR(turned[i].force_eV_per_A / straight[i].force_eV_per_A, 1, 1e-8);
}

TEST(Path, RelaxationActsOnlyWhereSomethingWouldBeCompressed) {
  const auto force = [](double nu, bool relaxed) {
    Problem problem = disc_problem(8, nu, DiscLoad{10}, {8});
    std::get<DiscSheet>(problem.sheet).rings = 32;
    problem.relaxed = relaxed;
    return solved_path(problem).at(0);
  };
  EXPECT_NEAR(force(0.19, true).force_eV_per_A / force(0.19, false).force_eV_per_A, 1, 1e-8);
  // nu < 0: hoop compression at the rim, which the relaxed sheet gives up.
  const Step relaxed = force(-0.4, true);
  const Step compressed = force(-0.4, false);
  EXPECT_LT(relaxed.energy_eV, compressed.energy_eV * (1 - 1e-3));
}

TEST(Path, EnergyIsTheWorkDone) {
  std::vector<double> depths;
  for (int i = 1; i <= 40; ++i) depths.push_back(0.5 * i);
  Problem problem = disc_problem(17.3, 0.36, DiscLoad{10}, depths, 112);
  std::get<DiscSheet>(problem.sheet).rings = 24;
  double work = 0;
  Step before;
  for (const Step& step : solved_path(problem)) {  // Simpson would be finer; the force is smooth enough
    work += 0.5 * (step.force_eV_per_A + before.force_eV_per_A) * (step.conjugate_depth_A - before.conjugate_depth_A);
    before = step;
  }
  EXPECT_NEAR(work / before.energy_eV, 1, 1e-3);
}

TEST(Path, DepthOfRecordIsTakenAtItsRadius) {
  // nu = 1/3, point: w = δ (1 − (r/a)^(2/3)).
  Problem problem = disc_problem(8, 1.0 / 3, PointLoad{}, {11});
  for (double r : {0.0, 1.42, 20.0}) {
    problem.record_radius_A = r;
    const Step step = solved_path(problem).at(0);
    EXPECT_NEAR(step.depth_A / (11 * (1 - std::pow(r / 110, 2.0 / 3))), 1, 6e-4) << "r " << r;
  }
}

TEST(Path, LevelsMayComeInAnyOrderAndBeFarApart) {
  Problem problem = disc_problem(17.3, 0.36, DiscLoad{10}, {24, 0.1, 0.1, 60, 6}, 112);
  std::get<DiscSheet>(problem.sheet).rings = 24;
  const auto steps = solved_path(problem);
  EXPECT_NEAR(steps[1].force_eV_per_A / steps[2].force_eV_per_A, 1, 1e-9);
  problem.levels = {6};
  EXPECT_NEAR(solved_path(problem).at(0).force_eV_per_A / steps[4].force_eV_per_A, 1, 1e-8);
  problem.control = Control::force;
  problem.levels = {steps[3].force_eV_per_A, steps[1].force_eV_per_A};
  const auto by_force = solved_path(problem);
  EXPECT_NEAR(by_force[0].conjugate_depth_A, 60, 1e-6);
  EXPECT_NEAR(by_force[1].conjugate_depth_A, 0.1, 1e-7);
}

TEST(Path, SlackSheetCarriesNothing) {
  // Biaxial compression: the relaxed sheet hangs loose until the depth has used up the slack.
  Problem problem = disc_problem(17.3, 0.36, DiscLoad{10}, {2, 20}, 112);
  problem.prestress_eV_per_A2 = -0.01 * Eigen::Matrix2d::Identity();
  const auto steps = solved_path(problem);
  EXPECT_EQ(steps[0].force_eV_per_A, 0);
  EXPECT_GT(steps[1].force_eV_per_A, 1);
}

TEST(Path, IsDoneInFewFactorisations) {
  // The main job's path: some ten to leave the flat sheet, one or two a level after that.
  Problem problem = disc_problem(17.3, 0.36, DiscLoad{10}, {}, 112);
  for (int i = 1; i <= 12; ++i) problem.levels.push_back(2 * i);
  problem.levels.push_back(24.2);
  const Report report = solve(problem, [](const Step&) { return true; });
  EXPECT_TRUE(report.converged);
  EXPECT_EQ(report.elements, 72 * 72);
  EXPECT_LE(report.factorisations, 26);
}

TEST(Path, EndsWhenTheCallerSaysSo) {
  Problem problem = disc_problem(8, 0.19, DiscLoad{10}, {2, 4, 6});
  std::get<DiscSheet>(problem.sheet).rings = 16;
  int calls = 0;
  const Report report = solve(problem, [&](const Step&) { return ++calls < 2; });
  EXPECT_EQ(calls, 2);
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.reason, "ended by the caller");
}

TEST(Path, NotConvergingIsReportedWithTheStepsSoFar) {
  Problem problem = disc_problem(8, 0.19, DiscLoad{10}, {2, 1e200});
  std::get<DiscSheet>(problem.sheet).rings = 16;
  std::vector<Step> steps;
  const Report report = solve(problem, [&](const Step& step) {
    steps.push_back(step);
    return true;
  });
  EXPECT_FALSE(report.converged);
  EXPECT_NE(report.reason.find("level 1"), std::string::npos) << report.reason;
  ASSERT_EQ(steps.size(), 2u);
  EXPECT_TRUE(steps[0].converged);
  EXPECT_FALSE(steps[1].converged);
}

}  // namespace
}  // namespace membrane
