// What a path's steps say of its break, and the sheet beside it.
#include "compare/study/breaking.hpp"

#include <gtest/gtest.h>

using namespace validate;

namespace {

using atomistic::Step;

constexpr double switch_A = 1.92;

Step step(double level, double force, double bond_A, bool search, bool broken) {
  Step s;
  s.target = s.conjugate_depth_A = level;
  s.depth_A = 1.2 * level;
  s.force_eV_per_A = force;
  s.longest_bond_A = bond_A;
  s.converged = true;
  s.search = search;
  s.broken = broken;
  return s;
}

/// Levels 8, 9 and 10, the last one broken; then the search.
std::vector<Step> path() {
  return {step(8, 60, 1.60, false, false),  step(9, 70, 1.66, false, false), step(10, 30, 2.5, false, true),
          step(9.5, 75, 1.70, true, false), step(9.75, 20, 2.4, true, true), step(9.625, 76.5, 1.74, true, false)};
}

TEST(Breaking, TheCurveHoldsWhatTheSearchFoundToBeBorne) {
  std::vector<Step> steps = path();
  steps.push_back(step(9, 70, 1.66, false, false));
  steps.back().unloading = true;
  std::vector<double> levels;
  for (const Step* s : steps_of_curve(steps)) levels.push_back(s->target);
  EXPECT_EQ(levels, (std::vector<double>{8, 9, 9.5, 9.625, 10}));
}

TEST(Breaking, LiesBetweenTheLastForceBorneAndWhereItsSlopeLeads) {
  const auto found = breaking_of(path(), switch_A);
  ASSERT_TRUE(found);
  EXPECT_DOUBLE_EQ(found->force_eV_per_A, 76.5);
  EXPECT_DOUBLE_EQ(found->depth_A, 1.2 * 9.625);
  EXPECT_DOUBLE_EQ(found->bracket[0], 76.5);
  EXPECT_NEAR(found->bracket[1], 76.5 + 12 * 0.125, 1e-9);  // 1.5 more from 9.5 to 9.625
  EXPECT_NEAR(found->depth_bracket_A[0], 1.2 * 9.625, 1e-12);
  EXPECT_NEAR(found->depth_bracket_A[1], 1.2 * 9.75, 1e-12);
  EXPECT_FALSE(found->past_artefact);
  EXPECT_TRUE(breaking_of(path(), 1.70)->past_artefact);
}

/// Under a controlled depth the force may have passed its largest value before the sheet breaks.
TEST(Breaking, IsTheLargestForceWhereItHasBegunToFall) {
  std::vector<Step> steps = path();
  steps[5].force_eV_per_A = 74;
  const auto found = breaking_of(steps, switch_A);
  EXPECT_DOUBLE_EQ(found->force_eV_per_A, 75);
  EXPECT_DOUBLE_EQ(found->bracket[1], 75);
  EXPECT_DOUBLE_EQ(found->depth_A, 1.2 * 9.625);
}

TEST(Breaking, IsNothingWhereNothingBroke) {
  EXPECT_FALSE(breaking_of({path()[0], path()[1]}, switch_A));
  EXPECT_FALSE(breaking_of({path()[2]}, switch_A)) << "nothing was borne before";
  EXPECT_FALSE(breaking_of({}, switch_A));
}

validate::Run sheet(Ended ended, LoadKind load) {
  validate::Run run;
  run.model = Model::sheet;
  run.constants = Constants::calibrated;
  run.load = load;
  run.ended = ended;
  run.depth_A = {9, 10, 11};
  run.force_eV_per_A = {60, 71, 70};
  return run;
}

TEST(Breaking, HasTheSheetsOwnBesideItWhereTheSheetTears) {
  for (const auto& [ended, load, known] :
       {std::tuple(Ended::rupture, LoadKind::disc, true), std::tuple(Ended::calibration_end, LoadKind::disc, false),
        std::tuple(Ended::rupture, LoadKind::point, false)}) {
    Result result;
    validate::Run atoms;
    atoms.model = Model::atomistic;
    settle_part(atoms);
    atoms.load = LoadKind::disc;
    atoms.atoms().breaking = breaking_of(path(), switch_A);
    result.runs = {atoms, sheet(ended, load)};
    result.agreement.emplace().load = LoadKind::disc;
    compare_breaking(result);
    ASSERT_TRUE(result.agreement->breaking);
    EXPECT_DOUBLE_EQ(result.agreement->breaking->force_eV_per_A, 76.5);
    EXPECT_EQ(result.agreement->breaking->sheet_force_eV_per_A.has_value(), known);
    if (!known) continue;
    EXPECT_DOUBLE_EQ(*result.agreement->breaking->sheet_force_eV_per_A, 71);
    EXPECT_DOUBLE_EQ(*result.runs[0].atoms().breaking->sheet_depth_A, 11);
  }
}

}  // namespace
