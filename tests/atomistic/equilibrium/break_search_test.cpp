// When a path's state counts as broken, and which levels are tried between the last that was borne and the first that
// broke.
#include "atomistic/equilibrium/break_search.hpp"

#include <gtest/gtest.h>

using namespace atomistic;

namespace {

constexpr double switch_A = 1.92;

Step state(double level, double bond_A, double force, bool broken = false) {
  Step step;
  step.target = step.conjugate_depth_A = level;
  step.longest_bond_A = bond_A;
  step.force_eV_per_A = force;
  step.converged = true;
  step.broken = broken;
  return step;
}

BreakSearch after(const std::vector<Step>& steps, bool by_depth = true) {
  BreakSearch search(switch_A, by_depth);
  for (const Step& step : steps) search.take(step);
  return search;
}

const std::vector<Step> borne = {state(8, 1.60, 60), state(9, 1.66, 70)};

TEST(BreakSearch, ABondBeyondThePotentialsReachIsBroken) {
  EXPECT_TRUE(after({}).broken(state(1, 2.0, 10)));
  EXPECT_FALSE(after({}).broken(state(1, 1.99, 10)));
}

/// Into the switch by steps: an artefact, and the load rises. By a jump: the sheet has lost its balance.
TEST(BreakSearch, AJumpIntoTheSwitchIsBrokenAndAWayIntoItIsNot) {
  EXPECT_TRUE(after(borne).broken(state(10, 1.921, 79)));
  EXPECT_FALSE(after(borne).broken(state(10, 1.919, 79)));
  EXPECT_FALSE(after(borne).broken(state(10, 1.921, 81))) << "the load has not fallen behind";
  Step restless = state(10, 1.921, 81);
  restless.converged = false;
  EXPECT_TRUE(after(borne).broken(restless));
  EXPECT_FALSE(after({state(8, 1.75, 60), state(9, 1.84, 70)}).broken(state(10, 1.93, 79)));
  EXPECT_FALSE(after(borne).broken(state(14, 1.93, 79))) << "in five steps a bond may grow as far";
  EXPECT_FALSE(after({borne[1]}).broken(state(10, 1.93, 79))) << "one state has no trend";
  EXPECT_FALSE(after({borne[1], state(10, 1.921, 80)}).broken(state(11, 1.99, 79)))
      << "in the switch only the reach counts";
}

/// A long step looks like a jump until there is a look between.
TEST(BreakSearch, TakesBackWhatWasALongStepIntoTheSwitch) {
  std::vector<Step> steps = {state(8, 1.75, 60), state(9, 1.80, 70), state(10, 1.93, 80, true)};
  EXPECT_TRUE(after(steps).next_level());
  EXPECT_FALSE(after(steps).refuted());
  steps.push_back(state(9.5, 1.89, 75));
  EXPECT_TRUE(after(steps).refuted());
  EXPECT_FALSE(after(steps).next_level());
  steps.back() = state(9.5, 1.86, 75);
  EXPECT_FALSE(after(steps).refuted());
  EXPECT_TRUE(after(steps).broken(state(9.75, 1.921, 78)));
  EXPECT_FALSE(after({steps[0], steps[1], steps[2], state(9.5, 1.875, 75)}).broken(state(9.75, 1.921, 78)));
  steps.push_back(state(9.75, 1.925, 78));
  EXPECT_TRUE(after(steps).refuted()) << "it came into the switch by steps";
}

TEST(BreakSearch, HalvesTheStepUntilTheForceIsKnown) {
  std::vector<Step> steps = borne;
  EXPECT_FALSE(after(steps).next_level()) << "nothing has broken";
  steps.push_back(state(10, 2.5, 20, true));
  EXPECT_DOUBLE_EQ(*after(steps).next_level(), 9.5);
  steps.push_back(state(9.5, 1.70, 75));  // borne
  EXPECT_DOUBLE_EQ(*after(steps).next_level(), 9.75);
  steps.push_back(state(9.75, 2.1, 30, true));
  EXPECT_DOUBLE_EQ(*after(steps).next_level(), 9.625);
  steps.push_back(state(9.625, 2.1, 30, true));
  // 75 + 10 · 0.125 is less than two per cent above 75, 75 + 10 · 0.0625 less than one
  EXPECT_DOUBLE_EQ(*after(steps).next_level(), 9.5625);
  steps.push_back(state(9.5625, 2.1, 30, true));
  EXPECT_FALSE(after(steps).next_level());
}

TEST(BreakSearch, OfALoadTheLevelIsTheForce) {
  const std::vector<Step> steps = {state(60, 1.6, 60), state(70, 1.66, 70), state(80, 5, 0, true)};
  EXPECT_DOUBLE_EQ(*after(steps, false).next_level(), 75);
  EXPECT_FALSE(after({state(60, 1.6, 60), state(79.5, 1.66, 79.5), state(80, 5, 0, true)}, false).next_level());
}

TEST(BreakSearch, EndsWhereThereIsNothingToFind) {
  EXPECT_FALSE(after({state(10, 2.5, 20, true)}).next_level()) << "nothing was borne";
  std::vector<Step> steps = borne;
  steps.push_back(state(10, 2.5, 20, true));
  steps.push_back(state(9.5, 1.7, 75));
  steps.back().converged = false;  // neither borne nor broken
  EXPECT_FALSE(after(steps).next_level());
  steps.back() = state(9.5, switch_A + 0.001, 75);  // it came into the switch by steps after all
  EXPECT_FALSE(after(steps).next_level());
}

TEST(BreakSearch, GoesOnInTheArtefactZoneWhereThePathDid) {
  EXPECT_TRUE(
      after({state(8, 1.93, 60), state(9, 1.94, 70), state(10, 2.5, 20, true), state(9.5, 1.95, 75)}).next_level());
}

}  // namespace
