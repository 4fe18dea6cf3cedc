// How the curve of a calibrated law ends: a sheet that softens, with more or less of it calibrated.
#include "compare/study/meridian_curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace validate;

namespace {

constexpr double radius_A = 30, tip_A = 6, rest_A = 1.42;

/// Equibiaxial stress has its maximum at E1 = E2 = C/(12 c) = 0.093, with C = C11 + C12 and −c the cubic term; the
/// longest bond is 1.55 Å there.
ContinuumExperiment softening_sheet(double holds_to_A) {
  ContinuumExperiment e;
  e.purpose = Purpose::calibrated_sheet;
  e.run.model = Model::sheet;
  settle_part(e.run);
  e.run.load = LoadKind::disc;
  e.run.constants = Constants::calibrated;
  e.run.a_A = radius_A, e.run.tip_A = tip_A, e.run.Eh_eV_per_A2 = 20, e.run.nu = 0.25;
  e.problem.discretisation = membrane::Meridian{};
  e.problem.sheet = membrane::DiscSheet{radius_A};
  e.problem.law = membrane::CauchyBorn{20, 0.25, {{3, 0, -12}}};
  e.problem.relaxed = false;
  e.problem.bending = membrane::clamped_all_round(1);
  e.problem.load = membrane::DiscLoad{tip_A};
  for (int k = 1; k <= 20; ++k) e.problem.levels.push_back(k);
  e.longest_bond = LongestBond{.rest_A = rest_A, .terms = {{1, 0, 0.71}, {0, 1, 0.71}}};
  e.law_holds_to_A = holds_to_A;
  e.last_bond_A = holds_to_A + 0.02;
  return e;
}

ContinuumExperiment solved(double holds_to_A) {
  ContinuumExperiment e = softening_sheet(holds_to_A);
  solve_on_meridian(e);
  return e;
}

void expect_equal_columns(const Run& run) {
  EXPECT_EQ(run.depth_A.size(), run.converged.size());
  EXPECT_EQ(run.depth_A.size(), run.longest_bond_A.size());
  EXPECT_EQ(run.depth_A.size(), run.continuum().newton_iterations.size());
}

TEST(MeridianCurve, ASheetTearsWhereItsLawHoldsAndHasLostItsStiffness) {
  const auto run = solved(1.9).run;
  EXPECT_EQ(run.ended, Ended::rupture) << run.ended_reason;
  EXPECT_NE(run.ended_reason.find("the sheet tears"), std::string::npos);
  expect_equal_columns(run);
  EXPECT_GT(run.longest_bond_A.back(), 1.55);
  EXPECT_LT(run.longest_bond_A.back(), 1.9);
  EXPECT_TRUE(std::ranges::is_sorted(run.depth_A));
  // between whole levels its end is looked for in sixteenths
  const std::size_t n = run.conjugate_depth_A.size();
  const double step_A = run.conjugate_depth_A[n - 1] - run.conjugate_depth_A[n - 2];
  EXPECT_TRUE(std::abs(step_A - 1.0 / 16) < 1e-9 || std::abs(step_A - 1) < 1e-9) << step_A;
}

/// The depth of rupture does not depend on where the levels happen to lie.
TEST(MeridianCurve, TheEndIsTheSheetsNotTheLevels) {
  ContinuumExperiment fine = softening_sheet(1.9);
  fine.problem.levels.clear();
  for (int k = 1; k <= 400; ++k) fine.problem.levels.push_back(0.05 * k);
  solve_on_meridian(fine);
  ASSERT_EQ(fine.run.ended, Ended::rupture);
  EXPECT_NEAR(solved(1.9).run.conjugate_depth_A.back(), fine.run.conjugate_depth_A.back(), 1.0 / 16);
}

TEST(MeridianCurve, TheSameSheetCalibratedLessFarEndsWithItsCalibration) {
  const auto run = solved(1.5).run, torn = solved(1.9).run;
  EXPECT_EQ(run.ended, Ended::calibration_end) << run.ended_reason;
  EXPECT_NE(run.ended_reason.find("calibrated to a longest bond of 1.50"), std::string::npos) << run.ended_reason;
  expect_equal_columns(run);
  EXPECT_GE(run.longest_bond_A.back(), 1.5);
  EXPECT_LT(run.depth_A.back(), torn.depth_A.back());
}

TEST(MeridianCurve, WithoutTheSearchItEndsAtTheLastLevelReached) {
  ContinuumExperiment e = softening_sheet(1.9);
  solve_on_meridian(e, false);
  EXPECT_EQ(e.run.ended, Ended::rupture);
  EXPECT_NEAR(e.run.conjugate_depth_A.back(), std::floor(solved(1.9).run.conjugate_depth_A.back()), 1e-9);
}

TEST(MeridianCurve, LevelsThatAreReachedAreAllThereIs) {
  ContinuumExperiment e = softening_sheet(1.9);
  e.problem.levels = {1, 2};
  solve_on_meridian(e);
  EXPECT_EQ(e.run.ended, Ended::depth_max);
  EXPECT_EQ(e.run.depth_A.size(), 2u);
}

}  // namespace
