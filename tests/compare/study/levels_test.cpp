#include "compare/study/levels.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "compare/study/continua.hpp"
#include "tests/compare/pairing/sample_material.hpp"

using namespace validate;

namespace {

using Numbers = std::vector<double>;

const Numbers& levels_of(const ContinuumExperiment& e) { return e.problem.levels; }

/// The judged load is another: no level is added for the verdict.
Case small_case() {
  Case c;
  c.radius_A = 15;
  c.tip_radius_A = 5;
  c.loads = {LoadKind::disc};
  c.judged_load = LoadKind::point;
  c.depth_max_A = 3;
  c.depth_step_A = 1;
  return c;
}

void expect_near(const Numbers& levels, const Numbers& expected) {
  ASSERT_EQ(levels.size(), expected.size()) << testing::PrintToString(levels);
  for (std::size_t i = 0; i < levels.size(); ++i) EXPECT_NEAR(levels[i], expected[i], 1e-12) << i;
}

TEST(Levels, ContinuaReachALittleBeyondTheAtomsOnBothSides) {
  const Case c = small_case();
  sample::Pairing pairing(c);
  PairedLoad& load = pairing.loads()[0];
  set_levels(c, load);
  expect_near(load.atoms->problem.levels, {1, 2, 3});
  expect_near(levels_of(*load.find(Purpose::like_for_like)), {0.5, 1, 2, 3, 3.06});
  expect_near(levels_of(*load.find(Purpose::paper)), {1, 2, 3});
  for (const Purpose cheap : {Purpose::calibrated_membrane, Purpose::calibrated_sheet, Purpose::nominal_radii,
                              Purpose::paired_radii, Purpose::bending})
    expect_near(levels_of(*load.find(cheap)), {0.5, 0.75, 1, 1.5, 2, 2.5, 3, 3.03, 3.06});
}

TEST(Levels, ForcesAndPressuresAreTheCasesInItsOrderInEveryModel) {
  Case forces = small_case();
  forces.forces_eV_per_A = {2, 4, 1, 3};
  Case pressures = small_case();
  pressures.loads = {LoadKind::pressure};
  pressures.pressures_eV_per_A3 = {2e-3, 1e-3};
  for (const auto& [c, levels] :
       {std::pair(forces, forces.forces_eV_per_A), std::pair(pressures, pressures.pressures_eV_per_A3)}) {
    sample::Pairing pairing(c);
    PairedLoad& load = pairing.loads()[0];
    set_levels(c, load);
    EXPECT_EQ(load.atoms->problem.levels, levels);
    for (const ContinuumExperiment& e : load.continua) EXPECT_EQ(levels_of(e), levels);
  }
}

TEST(Levels, GuidesStandAtTheAtomsLevels) {
  const Case c = small_case();
  sample::Pairing pairing(c);
  set_levels(c, pairing.loads()[0]);
  const auto& problem = pairing.loads()[0].atoms->problem;
  ASSERT_EQ(problem.guides.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(problem.guides[i].level, problem.levels[i]);
    EXPECT_GT(problem.guides[i].depth_A.front(), 0.9 * problem.levels[i]);  // deepest in the middle
    EXPECT_NEAR(problem.guides[i].depth_A.back(), 0, 0.15 * problem.levels[i]);
  }
}

/// Judged against the membrane: its depths of record at the atoms' levels must bracket the window, closely.
TEST(Levels, TheVerdictsWindowIsBracketed) {
  Case c = small_case();
  c.judged_load = LoadKind::disc;
  c.against = Against::membrane;
  c.window = {0.10, 0.15};
  sample::Pairing pairing(c);
  PairedLoad& load = pairing.loads()[0];
  set_levels(c, load);
  const Numbers& levels = load.atoms->problem.levels;
  EXPECT_TRUE(std::ranges::is_sorted(levels));
  for (const double asked : {1.0, 2.0, 3.0})
    EXPECT_TRUE(std::ranges::any_of(levels, [&](double level) { return std::abs(level - asked) < 1e-9; })) << asked;
  ASSERT_EQ(levels.size(), 5u);
  ContinuumExperiment membrane = *load.find(Purpose::like_for_like);
  set_levels(membrane, levels);
  solve(membrane, false);
  const Numbers& depths = membrane.run.depth_A;
  ASSERT_EQ(depths.size(), levels.size());
  const double a = pairing.sheet().effective_radius_A(), margin = 0.05;
  const auto between = [&](double lo, double hi) {
    return std::ranges::any_of(depths, [&](double depth) { return depth >= lo && depth <= hi; });
  };
  EXPECT_TRUE(between((1 - margin) * 0.10 * a, 0.10 * a)) << testing::PrintToString(depths);
  EXPECT_TRUE(between(0.15 * a, (1 + margin) * 0.15 * a)) << testing::PrintToString(depths);
}

TEST(Levels, AMembraneAloneHasTheCasesDepths) {
  Case c = small_case();
  c.models = Models::membrane;
  c.E_eV_per_A3 = 6, c.thickness_A = 3, c.nu = 0.2;
  std::vector<PairedLoad> loads = pair(c);
  set_levels(c, loads.at(0));
  expect_near(levels_of(loads[0].continua.at(0)), {1, 2, 3});
}

}  // namespace
