// Several cases in one command.
#include <gtest/gtest.h>
#include <signal.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/cli/run_program.hpp"
#include "tests/cli/run_support.hpp"

namespace {

namespace fs = std::filesystem;
using cli_tests::document;
using cli_tests::Outcome;
using cli_tests::run_validate;
using cli_tests::Words;
using cli_tests::WorkFolder;
using nlohmann::json;

Words batch(const Words& more) {
  Words words = {"indentation",
                 "--potential",
                 "tersoff,tersoff-1989",
                 "--radius",
                 "12,15",
                 "--tip-radius",
                 "5",
                 "--loads",
                 "disc",
                 "--depth-step",
                 "1",
                 "--depth-max",
                 "3",
                 "--out",
                 "batch",
                 "--quiet"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(Batch, RunsEveryPairInAFolderOfItsOwnAndCanBeResumed) {
  const WorkFolder folder;
  const Outcome outcome = run_validate(batch({}), folder.path());
  EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 3) << outcome.err;
  const json all = document(folder.path() / "batch" / "summary.json");
  cli_tests::expect_valid(all, "batch");
  ASSERT_EQ(all["cases"].size(), 4u);
  for (const json& entry : all["cases"]) {
    cli_tests::expect_valid(entry["summary"]);
    EXPECT_EQ(entry["summary"]["case"]["radius_A"], entry["radius_A"]);
    EXPECT_EQ(entry["summary"]["case"]["potential"], entry["potential"]);
    EXPECT_EQ(entry["summary"],
              document(folder.path() / "batch" / entry["folder"].get<std::string>() / "summary.json"));
    EXPECT_NE(outcome.out.find(entry["potential"].get<std::string>()), std::string::npos);
  }

  const Outcome refused = run_validate(batch({}), folder.path());
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.err.find("--resume"), std::string::npos);

  const auto stamp = [&](const char* name) {
    return fs::last_write_time(folder.path() / "batch" / name / "summary.json");
  };
  const auto kept = stamp("tersoff-R12");
  fs::remove_all(folder.path() / "batch" / "tersoff-R15");
  const Outcome resumed = run_validate(batch({"--resume"}), folder.path());
  EXPECT_EQ(resumed.exit_code, outcome.exit_code) << resumed.err;
  EXPECT_EQ(stamp("tersoff-R12"), kept);
  EXPECT_TRUE(fs::exists(folder.path() / "batch" / "tersoff-R15" / "summary.json"));
}

/// Membranes alone: no LAMMPS.
Words membranes(const char* radii, const Words& more) {
  Words words = {"indentation", "--models", "membrane", "--radius", radii,  "--E",          "1", "--thickness",
                 "1",           "--nu",     "0.3",      "--loads",  "disc", "--tip-radius", "5", "--depth-step",
                 "2",           "--out",    "batch",    "--quiet"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(Batch, ResumedEndsWithTheExitCodeItHad) {
  const WorkFolder folder;
  ASSERT_EQ(run_validate(membranes("40,50", {}), folder.path()).exit_code, 0);
  const fs::path batch = folder.path() / "batch";
  // No case is known that does not converge: one is told to have been.
  const auto cases = document(batch / "summary.json")["cases"];
  const std::string name = cases[1]["folder"];
  std::ofstream(batch / name / ".validate-run") << "validate run folder 1\nexit_code 4\nfile summary.json\n";
  EXPECT_EQ(run_validate(membranes("40,50", {"--resume"}), folder.path()).exit_code, 4);
  EXPECT_EQ(document(batch / "summary.json")["cases"][1]["exit_code"], 4);
  EXPECT_EQ(document(batch / "summary.json")["cases"][0]["exit_code"], 0);
}

TEST(Batch, OverwrittenLeavesNoCaseOfTheOneBefore) {
  const WorkFolder folder;
  ASSERT_EQ(run_validate(membranes("40,50", {}), folder.path()).exit_code, 0);
  const fs::path batch = folder.path() / "batch";
  const auto names = [&] {
    std::vector<std::string> found;
    const json all = document(batch / "summary.json");
    for (const json& entry : all["cases"]) found.push_back(entry["folder"]);
    return found;
  };
  const auto before = names();
  folder.write("batch/" + before[0] + "/notes.txt", "mine");
  folder.write("batch/notes.txt", "mine");
  ASSERT_EQ(run_validate(membranes("40,60", {"--overwrite"}), folder.path()).exit_code, 0);
  EXPECT_EQ(names()[0], before[0]);
  EXPECT_TRUE(fs::exists(batch / before[0] / "notes.txt"));
  EXPECT_TRUE(fs::exists(batch / "notes.txt"));
  EXPECT_FALSE(fs::exists(batch / before[1]));
  EXPECT_FALSE(fs::exists(batch / (before[1] + ".log")));
}

TEST(Batch, ACaseThatFailsIsNotTheOthers) {
  const WorkFolder folder;
  folder.write("bad.toml",
               "pair_style = \"tersof\"\npair_coeff = [\"* * {file} C\"]\nfile = \"BNC.tersoff\"\n"
               "interaction_range = 5\n");
  const Outcome outcome = run_validate(
      {"indentation", "--potential", "bad.toml,tersoff", "--radius", "12", "--models", "atomistic", "--tip-radius", "5",
       "--loads", "disc", "--depth-step", "1", "--depth-max", "2", "--out", "batch", "--quiet"},
      folder.path());
  EXPECT_EQ(outcome.exit_code, 2);
  const json cases = document(folder.path() / "batch" / "summary.json")["cases"];
  EXPECT_EQ(cases[0]["exit_code"], 2);
  EXPECT_TRUE(cases[0]["summary"].is_null());
  EXPECT_EQ(cases[1]["exit_code"], 0);
  EXPECT_NE(outcome.out.find("failed, exit code 2: see bad-R12.log"), std::string::npos) << outcome.out;
  EXPECT_GT(fs::file_size(folder.path() / "batch" / "bad-R12.log"), 20u);
}

TEST(Batch, InterruptedGoesOnWhereItWas) {
  const WorkFolder folder;
  const Words words = {"indentation", "--potential", "tersoff", "--radius",     "20,24", "--models",
                       "atomistic",   "--loads",     "disc",    "--tip-radius", "5",     "--depth-step",
                       "0.5",         "--out",       "batch",   "--quiet"};
  cli_tests::RunningValidate running(words, folder.path());
  const fs::path step = folder.path() / "batch/tersoff-R20/work/disc/steps/step-0000.bin";
  ASSERT_TRUE(cli_tests::appears(step));
  kill(running.pid(), SIGTERM);
  cli_tests::expect_says(running.wait(), 130, {"interrupted", "--resume", "batch"});
  EXPECT_TRUE(cli_tests::none_left(folder.path()));
  const auto written = fs::last_write_time(step);
  cli_tests::RunningValidate again(
      [&] {
        Words more = words;
        more.push_back("--resume");
        return more;
      }(),
      folder.path());
  ASSERT_TRUE(cli_tests::appears(folder.path() / "batch/tersoff-R20/work/disc/steps/step-0001.bin"));
  EXPECT_TRUE(!fs::exists(step) || fs::last_write_time(step) == written) << "not computed again";
  EXPECT_EQ(again.wait().exit_code, 0);
  const json all = document(folder.path() / "batch" / "summary.json");
  for (const json& entry : all["cases"]) EXPECT_EQ(entry["exit_code"], 0);
}

TEST(Batch, ChecksEveryCaseBeforeTheFirstStarts) {
  const WorkFolder folder;
  const auto refused = [&](const Words& words, const char* said) {
    const Outcome outcome = run_validate(words, folder.path());
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find(said), std::string::npos) << outcome.err;
  };
  refused({"indentation", "--potential", "tersoff,tersof"}, "'tersoff'?");
  refused({"indentation", "--radius", "60,5"}, "too small");
  refused({"indentation", "--radius", "60,60"}, "named twice");
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

}  // namespace
