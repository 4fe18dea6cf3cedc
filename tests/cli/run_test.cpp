// Whole runs of the real program: what they leave, and what happens when something goes wrong on the way.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <thread>

#include "tests/cli/run_support.hpp"

namespace {

namespace fs = std::filesystem;
using namespace cli_tests;
using nlohmann::json;

TEST(MainJob, WritesTheWholeRunFolder) {
  const WorkFolder folder;
  const Outcome outcome =
      run_validate({"indentation", "--radius", "30", "--out", "deep/run", "--json", "copy.json"}, folder.path());
  EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 3) << outcome.err;
  const fs::path run = folder.path() / "deep" / "run";
  for (const char* name : {"run.h5", "curves.csv", "summary.json", "figure.svg", "figure.png", "lammps.log",
                           "atoms-point.extxyz", "atoms-disc.extxyz"})
    EXPECT_GT(fs::file_size(run / name), 500u) << name;
  EXPECT_FALSE(fs::exists(run / "work"));
  const json summary = document(run / "summary.json");
  EXPECT_EQ(summary, document(folder.path() / "copy.json"));
  expect_valid(summary);
  // Two loads: atoms, membrane of the card, of the paper, of the calibrated law, and the sheet of the calibrated law.
  EXPECT_EQ(summary["runs"].size(), 10u);
  EXPECT_EQ(outcome.exit_code == 0, summary["agreement"]["outcome"] == "agree");
  EXPECT_EQ(outcome.exit_code, summary["exit_code"]);
  EXPECT_EQ(summary["agreement"]["against"], "sheet");
  EXPECT_EQ(summary["explanation"].size(), 2u);
  EXPECT_NE(outcome.err.find("evaluations"), std::string::npos) << "progress";
}

TEST(MainJob, AtomsAndContinuumAreTheSameExperiment) {
  const WorkFolder folder;
  run_validate(small_run({"--out", "run", "--pretension", "0.34 N/m"}), folder.path());
  const json summary = document(folder.path() / "run" / "summary.json");
  expect_valid(summary);
  const double bond = summary["card"]["a0_A"].get<double>() / std::sqrt(3.0);
  const double atoms_area = 0.75 * std::sqrt(3.0) * bond * bond;
  const double a = std::sqrt(summary["sheet"]["free_atoms"].get<int>() * atoms_area / std::numbers::pi) + 0.44 * bond;
  for (const char* load : {"point", "disc"}) {
    const json &atoms = run_of(summary, "atomistic", load), &card = run_of(summary, "membrane", load, "card");
    EXPECT_NEAR(card["a_A"].get<double>(), a, 0.1 * bond);  // the margin is the card's
    EXPECT_EQ(card["a_A"], atoms["a_A"]);
    EXPECT_EQ(card["tip_A"], atoms["tip_A"]);
    EXPECT_EQ(card["Eh_N_per_m"], summary["card"]["Eh_N_per_m"]);
    EXPECT_NEAR(card["pretension_N_per_m"].get<double>(), 0.34, 1e-9);
    for (const json& level : atoms["conjugate_depth_A"]) {  // the membrane has them all, one before and one beyond
      const auto close = [&](const json& other) { return std::abs(other.get<double>() - level.get<double>()) < 1e-6; };
      EXPECT_TRUE(std::ranges::any_of(card["conjugate_depth_A"], close)) << level;
    }
    EXPECT_LT(card["depth_A"].front(), atoms["depth_A"].front());
    EXPECT_GT(card["depth_A"].back(), atoms["depth_A"].back());
    EXPECT_EQ(run_of(summary, "membrane", load, "paper")["a_A"], 15.0);
  }
}

TEST(MainJob, JudgesDepthsThatBracketTheWindow) {
  const WorkFolder folder;
  run_validate(small_run({"--out", "run", "--loads", "disc", "--against", "membrane", "--window", "0.10,0.15"}),
               folder.path());
  const json agreement = document(folder.path() / "run" / "summary.json")["agreement"];
  const double a = document(folder.path() / "run" / "summary.json")["sheet"]["effective_radius_A"];
  EXPECT_LE(agreement["ratios"].front()["depth_A"].get<double>(), 0.10 * a);
  EXPECT_GT(agreement["ratios"].front()["depth_A"].get<double>(), 0.085 * a);
  EXPECT_GE(agreement["ratios"].back()["depth_A"].get<double>(), 0.15 * a);
  EXPECT_LT(agreement["ratios"].back()["depth_A"].get<double>(), 0.17 * a);
}

TEST(MainJob, TheSheetsWindowReachesFromThreePercentToLongBonds) {
  const WorkFolder folder;
  run_validate({"indentation", "--radius", "20", "--potential", "tersoff", "--tip-radius", "5", "--loads", "disc",
                "--out", "run"},
               folder.path());
  const json summary = document(folder.path() / "run" / "summary.json");
  ASSERT_FALSE(summary["agreement"].is_null()) << summary["agreement_skipped"];
  const json& agreement = summary["agreement"];
  const double a = summary["sheet"]["effective_radius_A"];
  EXPECT_LE(agreement["ratios"].front()["depth_A"].get<double>(), 0.03 * a);
  EXPECT_GT(agreement["ratios"].front()["depth_A"].get<double>(), 0.025 * a);
  const json& atoms = run_of(summary, "atomistic", "disc");
  EXPECT_GE(atoms["longest_bond_A"].back(), 1.65);  // the path goes on until the window ends
  EXPECT_LT(atoms["longest_bond_A"].back(), 1.70);
  EXPECT_LT(agreement["window"][1].get<double>(), atoms["depth_A"].back().get<double>() / a);
  EXPECT_LT(agreement["max_relative_difference"], 0.05);  // as small as this sheet is
}

TEST(MainJob, DeadForcesAreReportedExactlyAndInOrder) {
  const WorkFolder folder;
  run_validate(small_run({"--out", "run", "--loads", "disc", "--forces", "2,4,1,3"}), folder.path());
  const json summary = document(folder.path() / "run" / "summary.json");
  for (const json& run : summary["runs"]) {
    ASSERT_EQ(run["force_eV_per_A"].size(), 4u);
    const double expected[] = {2, 4, 1, 3};
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(run["force_eV_per_A"][i].get<double>(), expected[i], 1e-6);
    EXPECT_GT(run["depth_A"][1], run["depth_A"][3]);
    EXPECT_LT(run["depth_A"][2], run["depth_A"][0]);
  }
}

TEST(MainJob, AMembraneOfGivenConstantsNeedsNoAtoms) {
  const WorkFolder folder;
  const Outcome outcome = run_validate(
      {"indentation", "--models", "membrane", "--radius", "0.5 um", "--thickness", "0.335 nm", "--E", "1.0209 TPa",
       "--nu", "0.165", "--pretension", "0.34 N/m", "--loads", "disc", "--tip-radius", "1 nm", "--json", "-"},
      folder.path(), {"PATH=/nowhere"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const json summary = json::parse(outcome.out);  // nothing else on stdout
  expect_valid(summary);
  ASSERT_EQ(summary["runs"].size(), 1u);
  const json& run = summary["runs"][0];
  EXPECT_EQ(run["constants"], "given");
  EXPECT_EQ(run["a_A"], 5000.0);
  EXPECT_EQ(run["tip_A"], 10.0);
  EXPECT_NEAR(run["Eh_N_per_m"].get<double>(), 342.0, 0.01);
  EXPECT_TRUE(summary["card"].is_null());
  EXPECT_TRUE(summary["sheet"].is_null());
  EXPECT_TRUE(summary["agreement"].is_null());
}

TEST(MainJob, ADryRunComputesAndLeavesNothing) {
  const WorkFolder folder;
  const Outcome outcome = run_validate(small_run({"--dry-run"}), folder.path());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* word :
       {"\"radius_A\": 15", "atoms: about", "triangles", "estimate", "preconditioner: factor", "memory: about"})
    EXPECT_NE(outcome.out.find(word), std::string::npos) << word;
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(RunFolder, DefaultNamesAreNumbered) {
  const WorkFolder folder;
  const Words words = small_run({"--models", "membrane", "--loads", "disc", "--quiet"});
  for (int i = 0; i < 3; ++i) {
    const Outcome outcome = run_validate(words, folder.path());
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "");  // --quiet
  }
  for (const char* name : {"indentation-tersoff-R15", "indentation-tersoff-R15-2", "indentation-tersoff-R15-3"})
    EXPECT_TRUE(fs::exists(folder.path() / "runs" / name / "summary.json")) << name;
}

TEST(RunFolder, AFinishedRunIsReplacedOnlyWhenAskedTo) {
  const WorkFolder folder;
  const Words words = small_run({"--models", "membrane", "--loads", "disc", "--out", "run"});
  EXPECT_EQ(run_validate(words, folder.path()).exit_code, 0);
  std::ofstream(folder.path() / "run" / "notes.txt") << "mine";
  expect_says(run_validate(words, folder.path()), 2, {"finished run", "--overwrite"});
  Words again = small_run({"--models", "membrane", "--loads", "point", "--out", "run", "--overwrite"});
  EXPECT_TRUE(fs::exists(folder.path() / "run" / "membrane-disc-card.pvd"));
  EXPECT_EQ(run_validate(again, folder.path()).exit_code, 0);
  EXPECT_TRUE(fs::exists(folder.path() / "run" / "notes.txt"));
  for (const auto& entry : fs::directory_iterator(folder.path() / "run"))
    EXPECT_FALSE(entry.path().filename().string().starts_with("membrane-disc")) << entry.path();
  EXPECT_TRUE(fs::exists(folder.path() / "run" / "membrane-point-card.pvd"));
}

TEST(RunFolder, ARunKilledBeforeItsCaseWasKeptIsStarted) {
  for (const char* more : {"--quiet", "--resume", "--overwrite"}) {
    const WorkFolder folder;
    fs::create_directories(folder.path() / "run" / "work");
    const Outcome outcome =
        run_validate(small_run({"--models", "membrane", "--loads", "disc", "--out", "run", more}), folder.path());
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  }
}

TEST(RunFolder, SomebodyElsesFolderIsNotTouched) {
  const WorkFolder folder;
  folder.write("thesis.tex", "important");
  expect_says(run_validate(small_run({"--out", ".", "--overwrite"}), folder.path()), 2, {"does not hold a run"});
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
}

TEST(RunFolder, ThatCannotBeWrittenIsExitCodeSix) {
  const WorkFolder folder;
  expect_says(run_validate(small_run({"--out", "/proc/none/run"}), folder.path()), 6, {"/proc/none"});
}

TEST(Failure, APairStyleThatLammpsLacksIsBadInput) {
  const WorkFolder folder, work;
  folder.write(
      "bad.toml",
      "pair_style = \"tersof\"\npair_coeff = [\"* * {file} C\"]\nfile = \"BNC.tersoff\"\ninteraction_range = 5\n");
  const std::string path = (folder.path() / "bad.toml").string();
  expect_says(run_validate({"indentation", "--radius", "15", "--potential", path, "--tip-radius", "5", "--out", "run"},
                           work.path()),
              2, {"pair_style", "'tersof'", "tersoff/mod"});
  EXPECT_TRUE(fs::is_empty(work.path()));
}

TEST(Failure, LammpsErrorsAreQuotedWithTheLog) {
  const WorkFolder folder;
  folder.write(
      "bad.toml",
      "pair_style = \"tersoff 7\"\npair_coeff = [\"* * {file} C\"]\nfile = \"BNC.tersoff\"\ninteraction_range = 5\n");
  const Outcome outcome = run_validate({"indentation", "--radius", "15", "--potential", "bad.toml", "--tip-radius", "5",
                                        "--depth-step", "1", "--out", "run"},
                                       folder.path());
  expect_says(outcome, 5, {"potential card", "ERROR", "tersoff 7", "pair_style", "log.lammps"});
  expect_valid(document(folder.path() / "run" / "summary.json"));  // what there is, is written
  EXPECT_TRUE(document(folder.path() / "run" / "summary.json")["card"].is_null());
}

TEST(Failure, ALauncherThatFailsOrIsMissingIsNamed) {
  const WorkFolder folder;
  expect_says(run_validate(small_run({"--launcher", "no-such-launcher -n 2", "--out", "a"}), folder.path()), 5,
              {"no-such-launcher"});
  expect_says(run_validate(small_run({"--launcher", "false", "--out", "b"}), folder.path()), 5, {"status 1"});
}

TEST(Failure, WithoutMpiexecOneRankWorksAndMoreAreRefused) {
  const WorkFolder folder;
  const Outcome one = run_validate(small_run({"--loads", "disc", "--out", "a"}), folder.path(), {"PATH=/nowhere"});
  EXPECT_TRUE(one.exit_code == 0 || one.exit_code == 3) << one.err;
  EXPECT_NE(one.err.find("mpiexec"), std::string::npos) << "a warning";
  expect_says(run_validate(small_run({"--ranks", "2", "--out", "b"}), folder.path(), {"PATH=/nowhere"}), 5,
              {"mpiexec", "--launcher"});
}

class StoppedBy : public testing::TestWithParam<int> {};

/// A run that is stopped after its second depth goes on with --resume and ends with the numbers of a run that was not.
TEST_P(StoppedBy, ASignalARunCanBeResumed) {
  const WorkFolder folder;
  Words words = {"indentation", "--radius",     "30",  "--potential", "rebo", "--loads",
                 "disc",        "--depth-step", "0.6", "--ranks",     "2"};
  const auto into = [&](const std::string& out, const Words& more = {}) {
    Words all = words;
    all.insert(all.end(), {"--out", out});
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  run_validate(into("whole"), folder.path());

  RunningValidate running(into("cut"), folder.path());
  ASSERT_TRUE(appears(folder.path() / "cut/work/disc/steps/step-0001.bin"));
  kill(running.pid(), GetParam());
  const Outcome stopped = running.wait();
  if (GetParam() != SIGKILL) expect_says(stopped, 130, {"--resume"});
  EXPECT_TRUE(none_left(folder.path())) << "orphans";
  EXPECT_FALSE(fs::exists(folder.path() / "cut/summary.json"));
  expect_says(run_validate(into("cut"), folder.path()), 2, {"unfinished run", "--resume", "--overwrite"});
  expect_says(run_validate(into("cut", {"--resume", "--pretension", "0.1"}), folder.path()), 2,
              {"changed", "pretension"});

  const Outcome resumed = run_validate(into("cut", {"--resume"}), folder.path());
  EXPECT_TRUE(resumed.exit_code == 0 || resumed.exit_code == 3) << resumed.err;
  const json whole = document(folder.path() / "whole/summary.json"), cut = document(folder.path() / "cut/summary.json");
  const json &a = run_of(whole, "atomistic", "disc"), &b = run_of(cut, "atomistic", "disc");
  ASSERT_EQ(a["force_eV_per_A"].size(), b["force_eV_per_A"].size());
  for (std::size_t i = 0; i < a["force_eV_per_A"].size(); ++i) {
    const double expected = a["force_eV_per_A"][i];
    EXPECT_NEAR(b["force_eV_per_A"][i].get<double>(), expected, 1e-8 * expected) << i;
    EXPECT_EQ(a["force_evaluations"][i], b["force_evaluations"][i]) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Signal, StoppedBy, testing::Values(SIGKILL, SIGTERM, SIGINT));

TEST(Resume, APotentialThatHasChangedIsRefused) {
  const WorkFolder folder;
  const auto potential = [&](const std::string& range) {
    folder.write("mine.toml",
                 "pair_style = \"tersoff\"\npair_coeff = [\"* * {file} C\"]\nfile = \"BNC.tersoff\"\n"
                 "interaction_range = " +
                     range + "\n");
  };
  const Words words = small_run({"--out", "run", "--loads", "disc"});
  const auto with_mine = [&](const Words& more) {
    Words all = words;
    all[4] = "mine.toml";
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  potential("4.5");
  RunningValidate running(with_mine({}), folder.path());
  ASSERT_TRUE(appears(folder.path() / "run/work/case.json"));
  kill(running.pid(), SIGKILL);
  running.wait();
  ASSERT_TRUE(none_left(folder.path()));
  potential("6");
  expect_says(run_validate(with_mine({"--resume"}), folder.path()), 2, {"changed", "potential_definition"});
  potential("4.5");
  const Outcome resumed = run_validate(with_mine({"--resume"}), folder.path());
  EXPECT_TRUE(resumed.exit_code == 0 || resumed.exit_code == 3) << resumed.err;
}

TEST(Failure, AKilledRankIsNamedWithItsSignal) {
  const WorkFolder folder;
  RunningValidate running(
      {"indentation", "--radius", "30", "--loads", "disc", "--depth-step", "0.5", "--ranks", "1", "--out", "run"},
      folder.path());
  ASSERT_TRUE(appears(folder.path() / "run/work/disc/steps/step-0000.bin"));
  for (const auto& entry : fs::directory_iterator("/proc")) {
    std::ifstream in(entry.path() / "cmdline", std::ios::binary);
    const std::string line{std::istreambuf_iterator<char>(in), {}};
    if (line.find("validate-atoms") != std::string::npos && line.find(folder.path().string()) != std::string::npos)
      kill(std::stoi(entry.path().filename().string()), SIGSEGV);
  }
  expect_says(running.wait(), 5, {"signal 11", "disc"});
  const json summary = document(folder.path() / "run/summary.json");
  expect_valid(summary);
  const json& atoms = run_of(summary, "atomistic", "disc");
  EXPECT_TRUE(atoms["ended"].is_null());
  EXPECT_GE(atoms["force_eV_per_A"].size(), 1u) << "what was computed is kept";
}

TEST(Failure, TwoRunsCannotShareAFolder) {
  const WorkFolder folder;
  // Longer than --resume waits for what is left of a killed run.
  const Words run = {"indentation", "--radius", "90", "--loads", "disc", "--out", "run"};
  RunningValidate first(run, folder.path());
  ASSERT_TRUE(appears(folder.path() / "run/work/case.json"));
  Words again = run;
  again.push_back("--resume");
  expect_says(run_validate(again, folder.path()), 2, {"in use"});
  kill(first.pid(), SIGTERM);
  first.wait();
}

/// 1, 2 and 3 ranks: to 1e-4 at the default tolerance, to 1e-6 when converged to 1e-8 eV/Å.
class Ranks : public testing::TestWithParam<std::pair<const char*, double>> {};

TEST_P(Ranks, GiveTheSameForces) {
  const auto [tolerance, same] = GetParam();
  const WorkFolder folder;
  json runs[3];
  for (int ranks : {1, 2, 3}) {
    const std::string out = "r" + std::to_string(ranks);
    run_validate(small_run({"--loads", "disc", "--models", "atomistic", "--ranks", std::to_string(ranks), "--out", out,
                            "--force-tolerance", tolerance}),
                 folder.path());
    runs[ranks - 1] = run_of(document(folder.path() / out / "summary.json"), "atomistic", "disc")["force_eV_per_A"];
  }
  ASSERT_EQ(runs[0].size(), 4u);
  for (const json& run : runs)
    for (std::size_t i = 0; i < 4; ++i) {
      const double expected = runs[0][i];
      EXPECT_NEAR(run[i].get<double>(), expected, same * expected);
    }
}

INSTANTIATE_TEST_SUITE_P(Tolerance, Ranks, testing::Values(std::pair("1e-5", 1e-4), std::pair("1e-8", 1e-6)));

/// The lines of curves.csv without the remarks, which tell of the command.
std::string curves_of(const fs::path& run) {
  std::ifstream in(run / "curves.csv");
  std::string all;
  for (std::string line; std::getline(in, line);)
    if (!line.starts_with('#')) all += line + "\n";
  return all;
}

/// To the last bit: which rank has an atom depends on the way there.
TEST(Run, OfTwoRanksThatWasKilledEndsWithTheSameNumbers) {
  const WorkFolder folder;
  const auto two = [](const char* out, const Words& more = {}) {
    Words words = small_run({"--loads", "disc", "--ranks", "2", "--out", out});
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  const int exit_code = run_validate(two("whole"), folder.path()).exit_code;
  RunningValidate running(two("cut"), folder.path());
  ASSERT_TRUE(appears(folder.path() / "cut/work/disc/steps/step-0001.bin"));
  kill(running.pid(), SIGKILL);
  running.wait();
  EXPECT_EQ(run_validate(two("cut", {"--resume"}), folder.path()).exit_code, exit_code);
  EXPECT_EQ(curves_of(folder.path() / "cut"), curves_of(folder.path() / "whole"));
  EXPECT_GT(curves_of(folder.path() / "whole").size(), 1000u);
}

TEST(Run, InAFolderWhoseNameIsNoText) {
  const WorkFolder folder;
  const fs::path inside = folder.path() / "new\nline \xff'";
  fs::create_directory(inside);
  const Outcome outcome = run_validate(small_run({"--loads", "disc", "--out", "run"}), inside);
  EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 3) << outcome.err;
  EXPECT_TRUE(fs::exists(inside / "run/atoms-disc.extxyz"));
}

/// What a launcher and the system print between the events is passed over.
TEST(Run, UnderALauncherThatPrints) {
  const WorkFolder folder;
  folder.write("loud.sh", "#!/bin/sh\necho 'Loading module { x }'\n\"$@\"\necho done\n");
  fs::permissions(folder.path() / "loud.sh", fs::perms::owner_all);
  for (const std::string& launcher : {(folder.path() / "loud.sh").string(), std::string("mpiexec --tag-output -n 2")}) {
    const Outcome outcome = run_validate(
        small_run({"--loads", "disc", "--models", "atomistic", "--overwrite", "--out", "run", "--launcher", launcher}),
        folder.path());
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  }
}

}  // namespace
