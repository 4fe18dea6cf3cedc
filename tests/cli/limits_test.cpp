// What the system refuses a run: files, descriptors, memory, names, its own folder. Each is exit code 6 or 2 with a
// message, nothing half written stays, and the run goes on once there is room.
#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "tests/cli/run_support.hpp"

namespace {

using namespace cli_tests;
namespace fs = std::filesystem;

Words membrane(const Words& more = {}) {
  Words words = {"indentation", "--models", "membrane", "--loads",  "disc", "--E",          "5", "--thickness",
                 "1",           "--nu",     "0.2",      "--radius", "60",   "--tip-radius", "6", "--depth-step",
                 "6",           "--out",    "run"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// `validate` behind a command that limits it.
Outcome limited(const std::string& limit, const Words& words, const fs::path& folder) {
  std::string line = "cd '" + folder.string() + "' && prlimit " + limit + " '" VALIDATE_PROGRAM "'";
  for (const std::string& word : words) line += " '" + word + "'";
  const int status = std::system((line + " >out 2>err").c_str());
  std::ifstream in(folder / "err");
  return {.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1,
          .out = {},
          .err = {std::istreambuf_iterator<char>(in), {}}};
}

TEST(Limits, ADiskThatIsFullForRunH5IsExitCodeSix) {
  for (const int bytes : {2000, 30000, 80000}) {
    const WorkFolder folder;
    expect_says(limited("--fsize=" + std::to_string(bytes), membrane(), folder.path()), 6, {"cannot write"});
    const Outcome again = run_validate(membrane({"--resume"}), folder.path());
    EXPECT_EQ(again.exit_code, 0) << again.err;
    EXPECT_TRUE(fs::exists(folder.path() / "run/run.h5"));
  }
}

TEST(Limits, TooFewDescriptorsAreExitCodeSix) {
  for (const int count : {4, 5, 6, 7, 8}) {
    const WorkFolder folder;
    const Outcome outcome = limited("--nofile=" + std::to_string(count), membrane({"--quiet"}), folder.path());
    // The system's loader comes before the program, and has an exit code of its own.
    if (outcome.exit_code == 127 && outcome.err.find("loading shared libraries") != std::string::npos) {
      EXPECT_EQ(count, 4);
      continue;
    }
    EXPECT_TRUE(outcome.exit_code == 6 || outcome.exit_code == 0) << count << ": " << outcome.exit_code << outcome.err;
    EXPECT_TRUE(outcome.exit_code == 6 || count > 5) << count;
  }
}

TEST(Limits, TooLittleMemoryIsExitCodeSix) {
  const WorkFolder folder;
  const Outcome outcome = limited("--as=150000000", {"bulge", "--cells", "30", "--out", "run"}, folder.path());
  expect_says(outcome, 6, {"memory"});
}

TEST(Limits, NamesThatNoFileCanHaveAreBadInput) {
  const WorkFolder folder;
  const std::string endless(300, 'x');
  expect_says(run_validate({"indentation", "--out", endless}, folder.path()), 2, {"name too long"});
  expect_says(run_validate({"indentation", "--case", endless}, folder.path()), 2, {"name too long"});
  expect_says(run_validate({"indentation", "--potential", endless + ".toml"}, folder.path()), 2, {"name too long"});
  expect_says(run_validate(membrane({"--json", endless}), folder.path()), 2, {"name too long"});
  expect_says(run_validate({"figure", "1", "--out", endless}, folder.path()), 2, {"name too long"});
  expect_says(run_validate({"report", endless}, folder.path()), 2, {"name too long"});
  expect_says(run_validate({"report", folder.path().string(), "--out", endless}, folder.path()), 2, {});
  expect_says(run_validate({"fit", endless}, folder.path()), 2, {"name too long"});
  expect_says(run_validate({"fit", "x.csv", "--out", endless}, folder.path()), 2, {"x.csv"});
  for (const auto& entry : fs::directory_iterator(folder.path())) ADD_FAILURE() << entry.path();
}

/// A link to itself stands for every folder that cannot be entered: it fails for the administrator too.
TEST(Limits, FoldersThatCannotBeEnteredArePassedOver) {
  const WorkFolder folder;
  fs::create_symlink("loop", folder.path() / "loop");
  const std::string loop = (folder.path() / "loop").string(), endless = "/" + std::string(300, 'x');
  const std::string places = loop + ":" + endless;
  const Words plan = {"indentation", "--potential", "rebo", "--dry-run"};
  const std::string path = std::getenv("PATH");
  EXPECT_EQ(run_validate(plan, folder.path(), {"PATH=" + places + ":" + path}).exit_code, 0);
  EXPECT_EQ(run_validate(plan, folder.path(), {"LAMMPS_POTENTIALS=" + places}).exit_code, 0);
  EXPECT_EQ(run_validate(plan, folder.path(), {"KIM_API_PORTABLE_MODELS_DIR=" + places}).exit_code, 0);
  expect_says(run_validate(plan, folder.path(), {"VALIDATE_INPUTS=" + loop}), 2, {"VALIDATE_INPUTS"});
  expect_says(run_validate(membrane({"--json", loop}), folder.path()), 6, {"loop"});
  for (const Words& words : {Words{"indentation", "--out", loop}, {"report", loop}, {"indentation", "--case", loop}}) {
    const Outcome outcome = run_validate(words, folder.path());
    EXPECT_TRUE(outcome.exit_code == 2 || outcome.exit_code == 6) << outcome.exit_code << outcome.err;
    EXPECT_EQ(outcome.err.find("internal"), std::string::npos) << outcome.err;
  }
}

TEST(Limits, ARunFolderThatIsTakenAwayIsExitCodeSix) {
  const WorkFolder folder;
  Words words = membrane({"--quiet"});
  *std::next(std::find(words.begin(), words.end(), "--depth-step")) = "0.02";
  RunningValidate running(words, folder.path());
  ASSERT_TRUE(appears(folder.path() / "run/work/case.json"));
  fs::remove_all(folder.path() / "run");
  const Outcome outcome = running.wait();
  EXPECT_EQ(outcome.exit_code, 6) << outcome.err;
  EXPECT_NE(outcome.err.find("run"), std::string::npos) << outcome.err;
}

/// A path is bytes: a line's end in it, and what is no UTF-8.
TEST(Limits, AnyPathWillDo) {
  const WorkFolder folder;
  const std::string strange = "new\nline \xff'\"$(x)";
  const fs::path inside = folder.path() / strange;
  fs::create_directory(inside);
  const Outcome outcome = run_validate(membrane({"--json", "x.json"}), inside);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* name : {"run/run.h5", "run/figure.svg", "run/figure.png", "run/report.html", "x.json"})
    EXPECT_TRUE(fs::exists(inside / name)) << name;
  expect_says(run_validate({"report", inside.string()}, folder.path()), 2, {"run.h5"});
  EXPECT_EQ(run_validate({"report", (inside / "run").string()}, folder.path()).exit_code, 0);
  EXPECT_EQ(run_validate(membrane({"--overwrite"}), inside).exit_code, 0);
}

/// A gnuplot that takes its time is stopped, and the run goes on with one that does not.
TEST(Limits, AnInterruptWhileItDrawsIsExitCode130) {
  const WorkFolder folder;
  fs::create_directory(folder.path() / "slow");
  folder.write("slow/gnuplot", "#!/bin/sh\ntouch '" + (folder.path() / "drawing").string() + "'\nsleep 60\n");
  fs::permissions(folder.path() / "slow/gnuplot", fs::perms::owner_all);
  RunningValidate running(membrane(), folder.path(),
                          {"PATH=" + (folder.path() / "slow").string() + ":" + std::getenv("PATH")});
  ASSERT_TRUE(appears(folder.path() / "drawing"));
  kill(running.pid(), SIGINT);
  expect_says(running.wait(), 130, {"--resume"});
  EXPECT_TRUE(none_left(folder.path()));
  EXPECT_EQ(run_validate(membrane({"--resume"}), folder.path()).exit_code, 0);
  EXPECT_TRUE(fs::exists(folder.path() / "run/figure.svg"));
}

/// What a killed run's drawing goes on with keeps nobody out.
TEST(Limits, AGnuplotThatIsLeftBehindHoldsNoFolder) {
  const WorkFolder folder;
  fs::create_directory(folder.path() / "slow");
  folder.write("slow/gnuplot", "#!/bin/sh\ntrap '' TERM\ntouch '" + (folder.path() / "drawing").string() +
                                   "'\nfor i in 1 2 3 4 5 6 7 8; do sleep 1; done\n");
  fs::permissions(folder.path() / "slow/gnuplot", fs::perms::owner_all);
  RunningValidate running(membrane(), folder.path(),
                          {"PATH=" + (folder.path() / "slow").string() + ":" + std::getenv("PATH")});
  ASSERT_TRUE(appears(folder.path() / "drawing"));
  kill(running.pid(), SIGKILL);
  running.wait();
  EXPECT_EQ(run_validate(membrane({"--overwrite"}), folder.path()).exit_code, 0);
}

}  // namespace
