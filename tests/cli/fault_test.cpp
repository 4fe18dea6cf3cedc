// Faults put in from outside: each gives a message that says what and where, the right exit code, and leaves what was
// finished before it.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/cli/run_support.hpp"

namespace {

using namespace cli_tests;
namespace fs = std::filesystem;
using nlohmann::json;

std::string content_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string lammps_potential(const std::string& name) { return content_of(fs::path(LAMMPS_POTENTIALS_DIR) / name); }

/// The atomistic program's processes of a run, without the launcher, in the order of their start.
std::vector<pid_t> ranks_of(const fs::path& folder) {
  std::vector<pid_t> found;
  for (const auto& entry : fs::directory_iterator("/proc")) {
    const std::string line = content_of(entry.path() / "cmdline");
    const std::string program = line.substr(0, line.find('\0'));
    if (program.ends_with("validate-atoms") && line.find(folder.string()) != std::string::npos)
      found.push_back(std::stoi(entry.path().filename().string()));
  }
  std::sort(found.begin(), found.end());
  return found;
}

TEST(Fault, AParameterFileCutShortIsNamed) {
  const WorkFolder folder;
  fs::create_directory(folder.path() / "here");
  const std::string whole = lammps_potential("CH.rebo");
  folder.write("here/CH.rebo", whole.substr(0, whole.size() / 2));
  const Outcome outcome =
      run_validate({"indentation", "--radius", "15", "--potential", "rebo", "--tip-radius", "5", "--out", "run"},
                   folder.path(), {"LAMMPS_POTENTIALS=" + (folder.path() / "here").string()});
  expect_says(outcome, 5, {"CH.rebo", "cut short", "potential card"});
}

TEST(Fault, EditedParametersAreSaidAndNeverMixedInARun) {
  const WorkFolder folder;
  fs::create_directory(folder.path() / "here");
  std::string edited = lammps_potential("BNC.tersoff");
  const auto at = edited.find("430.00");
  ASSERT_NE(at, std::string::npos);
  edited.replace(at, 6, "431.00");
  folder.write("here/BNC.tersoff", edited);
  const std::vector<std::string> changed = {"LAMMPS_POTENTIALS=" + (folder.path() / "here").string()};
  const Words words = {"indentation", "--radius",     "30",  "--potential", "tersoff", "--loads",
                       "disc",        "--depth-step", "0.3", "--out",       "run"};
  RunningValidate running(words, folder.path());
  ASSERT_TRUE(appears(folder.path() / "run/work/disc/steps/step-0000.bin"));
  kill(running.pid(), SIGTERM);
  running.wait();
  Words again = words;
  again.push_back("--resume");
  expect_says(run_validate(again, folder.path(), changed), 2, {"edited", "--resume", "potential_definition"});
  EXPECT_TRUE(fs::exists(folder.path() / "run/work/disc/steps/step-0000.bin"));
}

TEST(Fault, ADiskThatIsFullIsExitCodeSix) {
  const WorkFolder folder;
  const Outcome outcome = run_validate(
      small_run({"--loads", "disc", "--models", "atomistic", "--out", "run", "--launcher", "prlimit --fsize=20000"}),
      folder.path());
  expect_says(outcome, 6, {"cannot write", "step-0000.bin", "File too large"});
  expect_valid(document(folder.path() / "run/summary.json"));
  EXPECT_TRUE(none_left(folder.path()));
}

TEST(Fault, OneKilledRankEndsAllAndKeepsTheSteps) {
  const WorkFolder folder;
  RunningValidate running(
      {"indentation", "--radius", "30", "--loads", "disc", "--depth-step", "0.5", "--ranks", "2", "--out", "run"},
      folder.path());
  ASSERT_TRUE(appears(folder.path() / "run/work/disc/steps/step-0000.bin"));
  const std::vector<pid_t> ranks = ranks_of(folder.path());
  ASSERT_EQ(ranks.size(), 2u);
  kill(ranks[1], SIGKILL);
  expect_says(running.wait(), 5, {"disc", "signal 9"});
  EXPECT_TRUE(none_left(folder.path()));
  const json summary = document(folder.path() / "run/summary.json");
  EXPECT_GE(run_of(summary, "atomistic", "disc")["force_eV_per_A"].size(), 1u);
}

/// A launcher that gives rank 1 of the curve another job than rank 0: an error that only that rank sees.
TEST(Fault, AnErrorOnRankOneAloneIsReported) {
  const WorkFolder folder;
  folder.write("uneven.sh",
               "#!/bin/sh\n"
               "case \"${OMPI_COMM_WORLD_RANK:-0}$2\" in 1*/disc/*) ;; *) exec \"$@\" ;; esac\n"
               "sed 's/\"tersoff\"/\"tersof\"/' \"$2\" >\"$2.other\"\n"
               "exec \"$1\" \"$2.other\"\n");
  fs::permissions(folder.path() / "uneven.sh", fs::perms::owner_all);
  const std::string launcher = "mpiexec -n 2 " + (folder.path() / "uneven.sh").string();
  const Outcome outcome = run_validate(
      small_run({"--loads", "disc", "--models", "atomistic", "--out", "run", "--launcher", launcher}), folder.path());
  expect_says(outcome, 5, {"disc", "no pair style 'tersof'"});
  EXPECT_TRUE(none_left(folder.path()));
}

}  // namespace
