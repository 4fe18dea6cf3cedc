// The whole comparison with a stub in the place of validate-atoms: what it makes of atoms whose law is known.
#include "compare/study/study.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <cmath>
#include <numbers>

#include "tests/support/temporary_folder.hpp"

using namespace validate;

namespace {

Case small_case(Models models) {
  Case c;
  c.radius_A = 15;
  c.tip_radius_A = 5;
  c.potential = "stub";
  c.loads = {LoadKind::disc};
  c.models = models;
  c.depth_max_A = 3;
  c.depth_step_A = 0.5;
  return c;
}

class Study : public testing::Test {
 protected:
  Study() { ::setenv("XDG_CACHE_HOME", (folder_ / "cache").c_str(), 1); }  // no card of the stub's among real ones

  StudyOutcome run(const Case& c, const std::string& orders) {
    PotentialFile potential;
    potential.potential.name = "stub";
    potential.potential.interaction_range_A = 2;
    potential.potential.pair_style = "stub " + orders;
    Progress quiet(true);
    return run_study(
        Command::indentation, c, potential,
        {.launch = {.program = STUB_ATOMS, .launcher = {}, .cores = 1}, .ranks = 1, .folder = folder_.path()}, quiet);
  }

  const TemporaryFolder folder_;
};

const Run* atoms_of(const Result& result) {
  for (const Run& run : result.runs)
    if (run.model == Model::atomistic) return &run;
  return nullptr;
}

TEST_F(Study, TakesTheCurveAndFitsTheConstantsThatMadeIt) {
  const StudyOutcome outcome = run(small_case(Models::atomistic), "linear 0.5 cubic 0.02");
  EXPECT_EQ(outcome.failure, "");
  const auto* atoms = atoms_of(outcome.result);
  ASSERT_TRUE(atoms);
  ASSERT_EQ(atoms->depth_A.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    const double d = 0.5 * static_cast<double>(i + 1);
    EXPECT_DOUBLE_EQ(atoms->depth_A[i], d);
    EXPECT_DOUBLE_EQ(atoms->force_eV_per_A[i], 0.5 * d + 0.02 * d * d * d);
  }
  EXPECT_EQ(atoms->ended, Ended::depth_max);
  ASSERT_TRUE(outcome.result.card && outcome.result.sheet && closed_form_fit(atoms->fits));
  EXPECT_DOUBLE_EQ(outcome.result.card->Eh_eV_per_A2, 20 * (1 - 0.25 * 0.25));
  // Eq. 16: c1 = π σ0h, c3 = E·h q³/a².
  const double nu = 0.25, a = outcome.result.sheet->effective_radius_A, q = 1 / (1.05 - 0.15 * nu - 0.16 * nu * nu);
  const double bond = outcome.result.card->a0_A / std::sqrt(3.0), atoms_area = 0.75 * std::sqrt(3.0) * bond * bond;
  EXPECT_NEAR(a, std::sqrt(outcome.result.sheet->free_atoms * atoms_area / std::numbers::pi) + 0.44 * bond, 1e-9);
  EXPECT_NEAR(closed_form_fit(atoms->fits)->pretension_eV_per_A2, 0.5 / std::numbers::pi, 1e-9);
  EXPECT_NEAR(closed_form_fit(atoms->fits)->Eh_eV_per_A2, 0.02 * a * a / (q * q * q), 1e-6);
}

TEST_F(Study, JudgesAtTheDepthsOfBoth) {
  const Case c = small_case(Models::both);
  const StudyOutcome one = run(c, "linear 0.2 cubic 0.02");
  std::filesystem::remove_all(folder_ / "work");  // its steps would be taken over
  const StudyOutcome twice = run(c, "linear 0.4 cubic 0.04");
  ASSERT_TRUE(one.result.agreement) << one.result.agreement_skipped;
  ASSERT_TRUE(twice.result.agreement) << twice.result.agreement_skipped;
  ASSERT_EQ(one.result.agreement->ratios.size(), twice.result.agreement->ratios.size());
  EXPECT_GE(one.result.agreement->ratios.size(), 4u);
  for (std::size_t i = 0; i < one.result.agreement->ratios.size(); ++i)
    EXPECT_NEAR(twice.result.agreement->ratios[i].ratio / one.result.agreement->ratios[i].ratio, 2, 1e-9);
  ASSERT_EQ(one.result.comparisons.size(), 1u);
  EXPECT_EQ(one.result.explanations.size(), 1u);
  EXPECT_EQ(one.result.law_missing, "");
}

TEST_F(Study, KeepsWhatCameBeforeAFailureAndGoesOnFromThere) {
  const StudyOutcome cut = run(small_case(Models::atomistic), "linear 0.5 kill 2");
  EXPECT_EQ(cut.failure_code, ExitCode::atomistic_failed);
  EXPECT_NE(cut.failure.find("disc load"), std::string::npos) << cut.failure;
  EXPECT_NE(cut.failure.find("signal 9"), std::string::npos) << cut.failure;
  ASSERT_TRUE(atoms_of(cut.result));
  EXPECT_EQ(atoms_of(cut.result)->depth_A.size(), 2u);
  EXPECT_FALSE(atoms_of(cut.result)->ended);
  const StudyOutcome whole = run(small_case(Models::atomistic), "linear 0.7");
  EXPECT_EQ(whole.failure, "");
  ASSERT_TRUE(atoms_of(whole.result));
  ASSERT_EQ(atoms_of(whole.result)->force_eV_per_A.size(), 6u);
  EXPECT_DOUBLE_EQ(atoms_of(whole.result)->force_eV_per_A[1], 0.5) << "finished before";
  EXPECT_DOUBLE_EQ(atoms_of(whole.result)->force_eV_per_A[2], 0.7 * 1.5);
}

TEST_F(Study, OneLoadsFailureIsNotTheOthers) {
  Case c = small_case(Models::atomistic);
  c.loads = {LoadKind::point, LoadKind::disc};
  std::filesystem::create_directories(folder_ / "work/point/steps");
  std::filesystem::create_directory(folder_ / "work/point/steps/step-0000.bin.part");  // in the way of its first step
  const StudyOutcome outcome = run(c, "linear 0.5");
  EXPECT_NE(outcome.failure.find("point load"), std::string::npos) << outcome.failure;
  ASSERT_EQ(outcome.result.runs.size(), 2u);
  for (const auto& curve : outcome.result.runs) EXPECT_EQ(curve.depth_A.size(), curve.load == LoadKind::disc ? 6u : 0u);
}

TEST_F(Study, ALevelThatDoesNotConvergeEndsTheCurve) {
  const StudyOutcome outcome = run(small_case(Models::atomistic), "linear 0.5 lost 3");
  EXPECT_EQ(outcome.failure, "");
  ASSERT_TRUE(atoms_of(outcome.result));
  EXPECT_EQ(atoms_of(outcome.result)->ended, Ended::not_converged);
  EXPECT_EQ(atoms_of(outcome.result)->ended_reason, "lost as asked");
  EXPECT_EQ(atoms_of(outcome.result)->converged, (std::vector<bool>{true, true, true, false}));
}

TEST_F(Study, WithoutACardThereIsNoComparison) {
  const StudyOutcome outcome = run(small_case(Models::both), "lammps 0");
  EXPECT_NE(outcome.failure.find("Lost atoms"), std::string::npos) << outcome.failure;
  EXPECT_FALSE(outcome.result.card);
  EXPECT_EQ(outcome.result.exit_code, static_cast<int>(ExitCode::atomistic_failed));
  EXPECT_EQ(outcome.result.agreement_skipped, "there is no potential card");
  EXPECT_TRUE(outcome.result.runs.empty());
  try {
    run(small_case(Models::both), "style 0");
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.exit_code(), ExitCode::bad_input);
    EXPECT_NE(std::string(error.what()).find("potential 'stub'"), std::string::npos) << error.what();
  }
}

}  // namespace
