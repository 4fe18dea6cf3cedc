#include "compare/verdict/agreement.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

using namespace validate;

namespace {

// a = 100 Å, so depth/a is the depth in per cent. The membrane is F = (depth/10)³ at other depths than the
// atoms'.
Run membrane() {
  validate::Run run;
  run.load = LoadKind::disc;
  run.constants = Constants::card;
  run.a_A = 100;
  for (double d = 1; d < 30; d += 2) {
    run.depth_A.push_back(d);
    run.force_eV_per_A.push_back(std::pow(d / 10, 3));
    run.converged.push_back(true);
  }
  return run;
}

Run atoms(const std::vector<double>& depths, const std::vector<double>& ratios) {
  validate::Run run;
  run.model = Model::atomistic;
  run.part.emplace<AtomsPart>().artefact.assign(depths.size(), false);
  run.load = LoadKind::disc;
  run.a_A = 100;
  run.depth_A = depths;
  for (std::size_t i = 0; i < depths.size(); ++i) {
    run.force_eV_per_A.push_back(ratios[i] * std::pow(depths[i] / 10, 3));
  }
  run.converged.assign(depths.size(), true);
  return run;
}

/// Judged against the membrane over 0.10 … 0.15, within 6 %.
Result result_with(const Run& atomistic) {
  Result result;
  result.resolved.against = Against::membrane;
  result.resolved.window = {0.10, 0.15};
  result.resolved.tolerance = 0.06;
  result.runs = {atomistic, membrane()};
  return result;
}

/// Judged as by default, against the calibrated sheet.
Result result_with_sheet(const Run& atomistic) {
  Result result;
  result.runs = {atomistic, membrane()};
  result.runs.push_back(membrane());
  result.runs.back().model = Model::sheet;
  result.runs.back().constants = Constants::calibrated;
  return result;
}

Run with_bonds(validate::Run run, const std::vector<double>& bonds) {
  run.longest_bond_A = bonds;
  return run;
}

std::vector<double> depths_judged(const Result& result) {
  std::vector<double> depths;
  for (const JudgedRatio& judged : result.agreement->ratios) depths.push_back(judged.depth_A);
  return depths;
}

TEST(Agreement, JudgesTheWindowAndTheDepthsThatBracketIt) {
  //                                        below  ≤lo  inside      ≥hi  above
  Result result = result_with(atoms({6, 8, 9.8, 11, 13, 15.2, 18}, {2, 2, 1.01, 1.02, 0.97, 0.95, 2}));
  judge(result);
  ASSERT_TRUE(result.agreement) << result.agreement_skipped;
  EXPECT_EQ(depths_judged(result), (std::vector{9.8, 11.0, 13.0, 15.2}));
  EXPECT_NEAR(result.agreement->max_relative_difference, 0.05, 1e-9);
  EXPECT_NEAR(result.agreement->ratios[0].ratio, 1.01, 1e-9);
  EXPECT_EQ(result.agreement->outcome, Outcome::agree);
  EXPECT_EQ(result.agreement->against, Model::membrane);
  EXPECT_EQ(result.agreement->load, LoadKind::disc);
}

TEST(Agreement, DepthsOnTheBordersAreTheEnds) {
  // 10.000001 is what a solver gives back for 10.
  Result result = result_with(atoms({8, 10.000001, 12, 14.999999, 17}, {2, 1.01, 1.02, 1.03, 2}));
  judge(result);
  ASSERT_TRUE(result.agreement) << result.agreement_skipped;
  EXPECT_EQ(depths_judged(result), (std::vector{10.000001, 12.0, 14.999999}));
}

TEST(Agreement, BeyondTheToleranceFails) {
  for (const double worst : {1.0601, 0.9399}) {
    Result result = result_with(atoms({10, 12, 15}, {1, worst, 1}));
    judge(result);
    ASSERT_TRUE(result.agreement) << result.agreement_skipped;
    EXPECT_EQ(result.agreement->outcome, Outcome::disagree) << worst;
  }
  Result result = result_with(atoms({10, 12, 15}, {1, 1.0599, 1}));
  judge(result);
  EXPECT_EQ(result.agreement->outcome, Outcome::agree);
}

TEST(Agreement, UsesTheAtomsRadiusTheCasesWindowAndLoad) {
  validate::Run wider = atoms({5, 10, 20, 31}, {1, 1, 1, 1});
  wider.a_A = 200;  // window 20 … 30 Å
  Result result = result_with(wider);
  result.runs[1].depth_A.back() = 40;
  result.runs[1].force_eV_per_A.back() = 64;
  judge(result);
  ASSERT_TRUE(result.agreement) << result.agreement_skipped;
  EXPECT_EQ(depths_judged(result), (std::vector{20.0, 31.0}));

  result.resolved.window = {0.04, 0.06};
  judge(result);
  ASSERT_TRUE(result.agreement) << result.agreement_skipped;
  EXPECT_EQ(depths_judged(result), (std::vector{5.0, 10.0, 20.0}));

  result.resolved.judged_load = LoadKind::point;
  judge(result);
  EXPECT_FALSE(result.agreement);
  EXPECT_EQ(result.agreement_skipped, "there is no atomistic run of the point load");
}

std::string reason_for(Result result) {
  judge(result);
  EXPECT_FALSE(result.agreement);
  return result.agreement_skipped;
}

TEST(Agreement, APathThatEndedEarlyGivesNoVerdict) {
  validate::Run short_path = atoms({8, 10, 12}, {1, 1, 1});
  short_path.ended = Ended::rupture;
  EXPECT_EQ(reason_for(result_with(short_path)),
            "the atoms' curve ends at depth/a = 0.120 (rupture), the window at 0.150");
  EXPECT_EQ(reason_for(result_with(atoms({11, 12, 16}, {1, 1, 1}))),
            "the atoms' curve begins at depth/a = 0.110, the window at 0.100");
  EXPECT_EQ(reason_for(result_with(atoms({}, {}))), "the atoms' curve has no usable point");

  validate::Run artefact = atoms({8, 10, 12, 15}, {1, 1, 1, 1});
  artefact.atoms().artefact.back() = true;
  artefact.ended = Ended::artefact;
  EXPECT_EQ(reason_for(result_with(artefact)),
            "the atoms' curve ends at depth/a = 0.120 (artefact), the window at 0.150");
}

TEST(Agreement, AMembraneThatDoesNotCoverTheDepthsGivesNoVerdict) {
  Result result = result_with(atoms({10, 12, 15}, {1, 1, 1}));
  result.runs[1].converged.assign(15, false);
  EXPECT_NE(reason_for(result).find("make no curve"), std::string::npos);
  for (const int i : {0, 1, 2, 3, 4, 5, 6}) result.runs[1].converged[i] = true;
  EXPECT_EQ(reason_for(result), "the membrane's curve covers depths from 1.00 to 13.00 Å, not the atoms' 15.00 Å");
  result.runs[1].constants = Constants::paper;  // not like for like
  EXPECT_EQ(reason_for(result), "there is no membrane (card constants) run of the disc load");
}

TEST(Agreement, TheSheetsWindowEndsWhereTheBondIsTooLong) {
  // Below 0.03 and from 1.65 Å on nothing is judged.
  validate::Run run = with_bonds(atoms({2, 3, 10, 20, 22, 24}, {2, 1.004, 0.995, 1.002, 1.003, 2}),
                                 {1.40, 1.41, 1.45, 1.55, 1.60, 1.70});
  run.ended = Ended::artefact;
  run.atoms().artefact.back() = true;
  Result result = result_with_sheet(run);
  judge(result);
  ASSERT_TRUE(result.agreement) << result.agreement_skipped;
  EXPECT_EQ(result.agreement->against, Model::sheet);
  EXPECT_EQ(depths_judged(result), (std::vector{3.0, 10.0, 20.0, 22.0}));
  EXPECT_NEAR(result.agreement->window[1], 0.23, 1e-12);  // halfway between 1.60 and 1.70
  EXPECT_NEAR(result.agreement->max_relative_difference, 0.005, 1e-9);
  EXPECT_EQ(result.agreement->outcome, Outcome::agree);
}

TEST(Agreement, APathToItsLargestDepthIsJudgedToThere) {
  validate::Run run = with_bonds(atoms({2.9, 10, 20}, {1, 1, 1.02}), {1.40, 1.45, 1.50});
  run.ended = Ended::depth_max;
  Result result = result_with_sheet(run);
  judge(result);
  ASSERT_TRUE(result.agreement) << result.agreement_skipped;
  EXPECT_NEAR(result.agreement->window[1], 0.20, 1e-12);
  EXPECT_EQ(result.agreement->outcome, Outcome::disagree);

  result.runs[0].ended = Ended::rupture;
  judge(result);
  EXPECT_EQ(result.agreement_skipped, "the atoms' curve ends at depth/a = 0.200 (rupture), the window at 0.500");
}

TEST(Agreement, WithoutACalibratedLawTheReasonIsTold) {
  Result result = result_with_sheet(atoms({3, 10, 20}, {1, 1, 1}));
  result.runs.pop_back();
  result.law_missing = "12 values do not determine 33 coefficients";
  judge(result);
  EXPECT_EQ(result.agreement_skipped,
            "there is no sheet (calibrated law) run of the disc load: 12 values do not determine 33 coefficients");
}

TEST(Agreement, DepthAtABondIsInterpolated) {
  const validate::Run run = with_bonds(atoms({1, 2, 3}, {1, 1, 1}), {1.40, 1.50, 1.70});
  EXPECT_NEAR(*depth_at_bond(run, 1.55), 2.25, 1e-12);
  EXPECT_EQ(depth_at_bond(run, 1.80), std::nullopt);
  EXPECT_EQ(depth_at_bond(atoms({1, 2}, {1, 1}), 1.5), std::nullopt);
}

TEST(Comparison, HoldsTheCalibratedContinuaBesideTheMembrane) {
  validate::Run run = with_bonds(atoms({5, 15}, {1.2, 0.9}), {1.4, 1.5});
  run.energy_eV = {1, 1};
  Result result = result_with_sheet(run);
  for (validate::Run& r : result.runs) r.energy_eV.assign(r.depth_A.size(), 1);
  for (double& f : result.runs[2].force_eV_per_A) f *= 1.2;
  validate::Run& sheet = result.runs[2];
  for (const double d : sheet.depth_A) sheet.longest_bond_A.push_back(1.40 + 0.02 * d);
  compare_curves(result);
  ASSERT_EQ(result.comparisons.size(), 1u);
  EXPECT_NEAR(result.comparisons[0].sheet_ratio[0], 1.0, 1e-9);
  EXPECT_NEAR(result.comparisons[0].sheet_ratio[1], 0.75, 1e-9);
  EXPECT_TRUE(std::isnan(result.comparisons[0].calibrated_membrane_ratio[0]));
  EXPECT_NEAR(result.comparisons[0].predicted_artefact_from_A, 15, 1e-9);  // 1.70 Å
}

TEST(Comparison, GivesRatiosAndRegimesPerDepth) {
  validate::Run stiff = atoms({5, 10, 15, 20, 25}, {1.30, 1.10, 1.00, 0.90, 0.80});
  stiff.atoms().artefact.back() = true;
  for (std::size_t i = 0; i < 5; ++i) stiff.energy_eV.push_back(1.5 * std::pow(stiff.depth_A[i], 4));
  validate::Run twin = membrane();
  for (const double d : twin.depth_A) twin.energy_eV.push_back(std::pow(d, 4));
  Result result;
  result.runs = {stiff, twin};
  result.resolved.regime_tolerance = 0.06;
  compare_curves(result);
  ASSERT_EQ(result.comparisons.size(), 1u);
  const Comparison& c = result.comparisons.front();
  ASSERT_EQ(c.depth_A.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) {
    const double ratio = std::array{1.30, 1.10, 1.00, 0.90, 0.80}[i];
    EXPECT_NEAR(c.force_ratio[i], ratio, 1e-9);
    EXPECT_NEAR(c.energy_ratio[i], 1.5, 1e-9);
    EXPECT_NEAR(c.depth_ratio[i], 1 / std::cbrt(ratio), 1e-9);  // F ∝ d³
    EXPECT_NEAR(c.depth_relative[i], c.depth_A[i] / 100, 1e-12);
  }
  EXPECT_EQ(c.regime,
            (std::vector{Regime::bending, Regime::bending, Regime::membrane, Regime::softening, Regime::artefact}));
  EXPECT_NEAR(c.bending_to_A, 12, 1e-6);      // 1.10 → 1.00 passes 1.06 at 2/5 of the way
  EXPECT_NEAR(c.softening_from_A, 18, 1e-6);  // 1.00 → 0.90 passes 0.94 at 3/5
  EXPECT_EQ(c.artefact_from_A, 25);
}

TEST(Comparison, NeedsBothCurves) {
  Result result;
  result.runs = {membrane()};
  compare_curves(result);
  EXPECT_TRUE(result.comparisons.empty());
}

JudgedRatio uncertain(double ratio, double u) {
  JudgedRatio judged;
  judged.depth_A = 10;
  judged.ratio = ratio;
  judged.u_input = judged.shares.clamp_radius = u;
  return judged;
}

Outcome outcome_of(std::vector<JudgedRatio> ratios) {
  Agreement agreement;
  agreement.tolerance = 0.01;
  agreement.ratios = std::move(ratios);
  settle(agreement);
  return agreement.outcome;
}

TEST(Settle, AgreementNeedsRoomForTheUncertaintyAtEveryDepth) {
  EXPECT_EQ(outcome_of({uncertain(1.004, 0.0029), uncertain(0.998, 0.003)}), Outcome::agree);
  EXPECT_EQ(outcome_of({uncertain(1.004, 0.0031), uncertain(0.998, 0.003)}), Outcome::undecided);
}

TEST(Settle, DisagreementNeedsADifferenceBeyondToleranceAndUncertainty) {
  EXPECT_EQ(outcome_of({uncertain(1, 0.001), uncertain(0.97, 0.0099)}), Outcome::disagree);
  EXPECT_EQ(outcome_of({uncertain(1, 0.001), uncertain(0.97, 0.0101)}), Outcome::undecided);
  EXPECT_EQ(outcome_of({uncertain(1.0101, 0)}), Outcome::disagree);
  EXPECT_EQ(outcome_of({uncertain(1.0099, 0)}), Outcome::agree);
}

TEST(Settle, NamesTheSourceThatDominates) {
  Agreement agreement;
  agreement.tolerance = 0.01;
  agreement.ratios = {uncertain(1.002, 0.004), uncertain(0.995, 0.001)};
  agreement.ratios[0].shares.law = 0.001;
  settle(agreement);
  EXPECT_EQ(agreement.dominant, "clamp_radius");
  EXPECT_NEAR(agreement.expanded_uncertainty, 0.008, 1e-12);
  EXPECT_NEAR(agreement.max_relative_difference, 0.005, 1e-12);
}

}  // namespace
