#include "compare/process/many_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "compare/base/errors.hpp"
#include "compare/base/interrupt.hpp"
#include "compare/process/run_folder.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace validate;

namespace {

namespace fs = std::filesystem;

/// Cases whose program is a shell script; it is started as `script --out FOLDER --quiet [--resume]`.
class Cases {
 public:
  void add(const std::string& name, const std::string& script, int cores = 1) {
    list.push_back({name, {"/bin/sh", "-c", script, name}, path(name), path(name + ".log"), cores});
  }
  std::vector<CaseEnd> run(bool resume = false, const std::vector<int>& cores = {0, 1}) {
    Progress quiet(true);
    return run_cases(list, resume, quiet, cores);
  }
  fs::path path(const std::string& name) const { return folder / name; }
  std::string read(const std::string& name) const { return folder.read(name); }

  const TemporaryFolder folder;
  std::vector<ManyCase> list;
};

/// Start and end of a case as lines of one file, written at once.
std::string told(const Cases& cases, const std::string& work) {
  const std::string file = cases.path("told").string();
  return "echo \"+$0\" >> " + file + "; " + work + "; echo \"-$0\" >> " + file;
}

std::vector<std::string> lines(const std::string& text) {
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), {}};
}

TEST(ManyCases, RunInOrderAndNeverMoreThanTheCoresHold) {
  Cases cases;
  for (const char* name : {"a", "b", "c", "d", "e"}) cases.add(name, told(cases, "sleep 0.1"));
  for (const CaseEnd& end : cases.run()) {
    EXPECT_EQ(end.exit_code, 0);
    EXPECT_GE(end.seconds, 0.1);
    EXPECT_LT(end.seconds, 10);
    EXPECT_EQ(end.reason, "");
  }
  int running = 0, most = 0;
  std::string started;
  for (const std::string& line : lines(cases.read("told"))) {
    running += line[0] == '+' ? 1 : -1;
    most = std::max(most, running);
    if (line[0] == '+') started += line[1];
  }
  EXPECT_EQ(most, 2) << "side by side, and no more";
  std::sort(started.begin(), started.begin() + 2);  // the first two start together
  EXPECT_EQ(started.substr(0, 2), "ab");
  EXPECT_EQ(started.size(), 5u);
}

TEST(ManyCases, OneThatWantsAllCoresRunsAlone) {
  Cases cases;
  cases.add("a", told(cases, "sleep 0.1"));
  cases.add("B", told(cases, "sleep 0.1; nproc > " + cases.path("cores").string()), 64);
  cases.add("c", told(cases, "sleep 0.1"));
  cases.run(false, usable_cores());
  EXPECT_EQ(lines(cases.read("told")), (std::vector<std::string>{"+a", "-a", "+B", "-B", "+c", "-c"}));
  EXPECT_EQ(cases.read("cores"), std::to_string(usable_cores().size()) + "\n");
}

TEST(ManyCases, EachRunsOnTheCoresThatItWants) {
  Cases cases;
  cases.add("a", "unset OMP_NUM_THREADS; nproc > " + cases.path("cores").string());
  const std::vector<int> own = usable_cores();
  cases.run(false, own);
  EXPECT_EQ(cases.read("cores"), "1\n");
  EXPECT_EQ(usable_cores(), own) << "this program's are as before";
}

TEST(ManyCases, TheFailureOfOneIsItsOwn) {
  Cases cases;
  cases.add("disagrees", "echo a warning >&2; exit 3");
  cases.add("fails", "echo first >&2; echo 'validate: error: no such thing' >&2; exit 5");
  cases.add("killed", "kill -9 $$");
  cases.list.push_back({"missing", {"no-such-program-at-all"}, cases.path("missing"), cases.path("missing.log"), 1});
  cases.list.push_back({"no-log", {"true"}, cases.path("no-log"), cases.path("none/log"), 1});
  cases.add("floods", "head -c 1000000 /dev/zero | tr '\\0' '\\n'");
  cases.add("good", "exit 0");
  const auto ends = cases.run();
  ASSERT_EQ(ends.size(), 7u);
  EXPECT_EQ(ends[0].exit_code, 3);
  EXPECT_EQ(ends[0].reason, "") << "a verdict needs none";
  EXPECT_EQ(ends[1].exit_code, 5);
  EXPECT_EQ(ends[1].reason, "validate: error: no such thing");
  EXPECT_EQ(ends[2].exit_code, 128 + 9);
  EXPECT_NE(ends[2].reason.find("signal 9"), std::string::npos);
  EXPECT_EQ(ends[3].exit_code, 5);
  EXPECT_NE(ends[3].reason.find("no-such-program-at-all"), std::string::npos);
  EXPECT_EQ(ends[4].exit_code, 6);
  EXPECT_EQ(ends[5].exit_code, 0);
  EXPECT_EQ(ends[6].exit_code, 0);
}

/// What `validate` leaves of a run in a folder.
void leave_run(const fs::path& out, std::optional<ExitCode> finished) {
  RunOptions options;
  options.out = out;
  RunFolder folder(options, "unused", {{"radius_A", 20}});
  if (finished) folder.finish(*finished);
}

TEST(ManyCases, ResumedTellTheExitCodesOfFinishedOnesAgain) {
  Cases cases;
  const std::string script = "echo \"$@\" >> " + cases.path("words").string();
  for (const char* name : {"agrees", "lost", "half", "new"}) cases.add(name, script);
  leave_run(cases.path("agrees"), ExitCode::success);
  leave_run(cases.path("lost"), ExitCode::not_converged);
  leave_run(cases.path("half"), std::nullopt);
  const auto ends = cases.run(true, {0});
  EXPECT_EQ(ends[0].exit_code, 0);
  EXPECT_TRUE(ends[0].finished_before);
  EXPECT_EQ(ends[1].exit_code, 4);
  EXPECT_TRUE(ends[1].finished_before);
  EXPECT_FALSE(ends[2].finished_before);
  EXPECT_FALSE(ends[3].finished_before);
  EXPECT_EQ(cases.read("words"), "--out " + cases.path("half").string() + " --quiet --resume\n--out " +
                                     cases.path("new").string() + " --quiet\n");
}

TEST(ManyCases, NotResumedStartEveryCase) {
  Cases cases;
  cases.add("agrees", "exit 2");  // what validate says of a folder in use
  leave_run(cases.path("agrees"), ExitCode::success);
  EXPECT_EQ(cases.run()[0].exit_code, 2);
}

/// In a process of its own, which the signal is for; all cases are stopped before the error.
TEST(ManyCasesDeathTest, ASignalStopsAll) {
  Cases cases;
  cases.add("sleeps", "trap 'trap \"\" TERM; echo stopped >> " + cases.path("told").string() +
                          "; exit 130' TERM; touch " + cases.path("ready").string() + "; while :; do sleep 0.05; done");
  cases.add("signals",
            "while [ ! -e " + cases.path("ready").string() + " ]; do sleep 0.05; done; kill -TERM $PPID; sleep 60");
  cases.add("never", "touch " + cases.path("started").string());
  const auto run = [&] {
    catch_interrupts();
    try {
      cases.run();
    } catch (const Error& error) {
      ::_exit(static_cast<int>(error.exit_code()));
    }
    ::_exit(0);
  };
  EXPECT_EXIT(run(), testing::ExitedWithCode(130), "");
  EXPECT_EQ(cases.read("told"), "stopped\n");
  EXPECT_FALSE(fs::exists(cases.path("started")));
}

}  // namespace
