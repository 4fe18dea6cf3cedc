#include "compare/study/judge.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace validate;

namespace {

Run run_of(Model model, std::optional<Constants> constants, double stiffness) {
  validate::Run run;
  run.model = model;
  settle_part(run);
  run.load = LoadKind::disc;
  run.constants = constants;
  run.a_A = 100, run.tip_A = 10, run.Eh_eV_per_A2 = 20, run.nu = 0.2;
  run.ended = Ended::depth_max;
  for (double d = 1; d <= 30; ++d) {
    run.depth_A.push_back(d);
    run.conjugate_depth_A.push_back(d);
    run.force_eV_per_A.push_back(stiffness * std::pow(d / 10, 3));
    run.energy_eV.push_back(run.force_eV_per_A.back() * d / 4);
    run.converged.push_back(true);
  }
  if (run.is_atomistic()) {
    run.atoms().artefact.assign(run.depth_A.size(), false);
    run.longest_bond_A.assign(run.depth_A.size(), 1.5);
  }
  return run;
}

ContinuumExperiment experiment(Purpose purpose, Model model, Constants constants, double stiffness) {
  ContinuumExperiment e;
  e.purpose = purpose;
  e.run = run_of(model, constants, stiffness);
  return e;
}

std::vector<PairedLoad> solved(double atoms_stiffness) {
  std::vector<PairedLoad> loads(1);
  loads[0].load = LoadKind::disc;
  loads[0].atoms.emplace().run = run_of(Model::atomistic, std::nullopt, atoms_stiffness);
  loads[0].continua = {experiment(Purpose::like_for_like, Model::membrane, Constants::card, 1),
                       experiment(Purpose::paper, Model::membrane, Constants::paper, 0.9),
                       experiment(Purpose::calibrated_membrane, Model::membrane, Constants::calibrated, 0.95),
                       experiment(Purpose::calibrated_sheet, Model::sheet, Constants::calibrated, 1.1),
                       experiment(Purpose::nominal_radii, Model::membrane, Constants::card, 1.02),
                       experiment(Purpose::paired_radii, Model::membrane, Constants::card, 1),
                       experiment(Purpose::bending, Model::sheet, Constants::card, 1.2)};
  return loads;
}

StudyOutcome judged(std::vector<PairedLoad> loads) {
  StudyOutcome outcome;
  judge_all(loads, {}, {}, outcome);
  settle_exit(outcome);
  return outcome;
}

TEST(JudgeAll, HandsOverAtomsThenTrianglesThenCalibratedAndNoStage) {
  const Result result = judged(solved(1.1)).result;
  std::vector<std::pair<Model, std::optional<Constants>>> found;
  for (const auto& run : result.runs) found.emplace_back(run.model, run.constants);
  const std::vector<std::pair<Model, std::optional<Constants>>> expected = {{Model::atomistic, std::nullopt},
                                                                            {Model::membrane, Constants::card},
                                                                            {Model::membrane, Constants::paper},
                                                                            {Model::membrane, Constants::calibrated},
                                                                            {Model::sheet, Constants::calibrated}};
  EXPECT_EQ(found, expected);
  for (const auto& run : result.runs) EXPECT_FALSE(run.fits.empty()) << run.fit_skipped;
  ASSERT_EQ(result.comparisons.size(), 1u);
  ASSERT_EQ(result.explanations.size(), 1u);
  EXPECT_NEAR(result.explanations[0].bending[4], (1.2 - 1) / 1.02, 1e-9);
  EXPECT_NEAR(result.explanations[0].large_strain[4], (1.1 - 1.2) / 1.02, 1e-9);
  EXPECT_NEAR(result.explanations[0].remainder[4], 0, 1e-9);
}

TEST(JudgeAll, WithoutAStageNothingIsExplained) {
  std::vector<PairedLoad> loads = solved(1.1);
  loads[0].continua.pop_back();
  EXPECT_TRUE(judged(std::move(loads)).result.explanations.empty());
}

TEST(SettleExit, AgreementIsZeroAndDisagreementThreeWithItsNumber) {
  const Result agrees = judged(solved(1.1)).result, differs = judged(solved(1.155)).result;
  ASSERT_TRUE(agrees.agreement && differs.agreement) << agrees.agreement_skipped;
  EXPECT_EQ(agrees.agreement->outcome, Outcome::agree);
  EXPECT_EQ(agrees.exit_code, 0);
  EXPECT_EQ(agrees.exit_reason, "");
  EXPECT_EQ(differs.agreement->outcome, Outcome::disagree);
  EXPECT_EQ(differs.exit_code, 3);
  EXPECT_EQ(differs.exit_reason, "the atoms' force differs from the sheet's by up to 5 %, more than 1 %");
}

TEST(SettleExit, NothingToJudgeIsZero) {
  std::vector<PairedLoad> loads = solved(2);
  loads[0].atoms.reset();
  const Result result = judged(std::move(loads)).result;
  EXPECT_FALSE(result.agreement);
  EXPECT_EQ(result.exit_code, 0);
}

TEST(SettleExit, ASolverThatGaveUpComesBeforeTheVerdict) {
  std::vector<PairedLoad> loads = solved(1.155);
  validate::Run& membrane = loads[0].continua[0].run;
  membrane.ended = Ended::not_converged;
  membrane.ended_reason = "no descent";
  const Result result = judged(std::move(loads)).result;
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_EQ(result.exit_reason, "membrane run of the disc load: no descent");
}

TEST(SettleExit, ACalibratedLawMayLoseItsStability) {
  std::vector<PairedLoad> loads = solved(1.1);
  loads[0].continua[3].run.ended = Ended::not_converged;
  EXPECT_EQ(judged(std::move(loads)).result.exit_code, 0);
}

TEST(SettleExit, WhatFailedComesFirst) {
  StudyOutcome outcome = judged(solved(1.155));
  outcome.result.runs[1].ended = Ended::not_converged;
  outcome.failure = "disc load: signal 9";
  settle_exit(outcome);
  EXPECT_EQ(outcome.result.exit_code, 5);
  EXPECT_EQ(outcome.result.exit_reason, "disc load: signal 9");
  outcome.failure_code = ExitCode::file_failed;
  settle_exit(outcome);
  EXPECT_EQ(outcome.result.exit_code, 6);
}

}  // namespace
