// Jobs of the atomistic program side by side, with a stub in its place.
#include "compare/process/atoms.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "atomistic/protocol/step_file.hpp"
#include "compare/base/errors.hpp"
#include "compare/base/interrupt.hpp"
#include "compare/process/atoms_curves.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace validate;

namespace {

namespace fs = std::filesystem;

class Jobs {
 public:
  void add(const std::string& name, const std::string& orders, int ranks = 1) {
    atomistic::CurveJob curve;
    curve.problem.potential.pair_style = "stub linear 1 " + orders;
    curve.problem.levels = {1, 2, 3};
    curve.steps_folder = (folder / name / "steps").string();
    fs::create_directories(curve.steps_folder);
    list.push_back({name, {curve, (folder / name / "log.lammps").string()}, ranks});
  }

  std::vector<AtomsOutcome> run(const AtomsLaunch& launch) {
    return run_jobs(launch, list, folder.path(), [&](std::size_t index, const atomistic::Event& event) {
      if (std::holds_alternative<atomistic::StartEvent>(event)) ++running_, most = std::max(most, running_);
      if (std::holds_alternative<atomistic::StepEvent>(event)) ++steps[list[index].name];
      if (std::holds_alternative<atomistic::EndEvent>(event)) --running_;
      if (std::holds_alternative<atomistic::StartEvent>(event)) started += list[index].name;
    });
  }

  std::size_t files(const std::string& name) const {
    return atomistic::read_finished_steps(folder / name / "steps").size();
  }

  const TemporaryFolder folder;
  std::vector<AtomsJob> list;
  std::map<std::string, int> steps;  ///< told of
  std::string started;
  int most = 0;

 private:
  int running_ = 0;
};

const AtomsLaunch two_cores{.program = STUB_ATOMS, .launcher = {}, .cores = 2};

TEST(Jobs, RunInOrderAndNoMoreThanTheCores) {
  Jobs jobs;
  for (const char* name : {"a", "b", "c", "d"}) jobs.add(name, "sleep 60");
  for (const AtomsOutcome& outcome : jobs.run(two_cores)) EXPECT_TRUE(outcome.finished) << outcome.failure;
  EXPECT_EQ(jobs.most, 2);
  ASSERT_EQ(jobs.started.size(), 4u);
  EXPECT_LT(std::max(jobs.started.find('a'), jobs.started.find('b')),
            std::min(jobs.started.find('c'), jobs.started.find('d')));
  for (const char* name : {"a", "b", "c", "d"}) {
    EXPECT_EQ(jobs.steps[name], 3);
    EXPECT_EQ(jobs.files(name), 3u);
  }
}

TEST(Jobs, OneThatWantsMoreThanThereIsRunsAlone) {
  Jobs jobs;
  const AtomsLaunch launch{.program = STUB_ATOMS, .launcher = {"env"}, .cores = 2};
  jobs.add("a", "sleep 60");
  jobs.add("b", "sleep 60", 5);
  for (const AtomsOutcome& outcome : jobs.run(launch)) EXPECT_TRUE(outcome.finished) << outcome.failure;
  EXPECT_EQ(jobs.most, 1);
}

TEST(Jobs, EachFailureIsItsOwnAndIsTold) {
  struct Failing {
    const char *name, *orders;
    atomistic::Fault fault;
    std::vector<std::string> said;
    std::size_t kept;
  };
  using atomistic::Fault;
  const std::vector<Failing> all = {
      {"killed", "kill 1", Fault::program, {"ended by signal 9", "killed/log.lammps"}, 1},
      {"left", "exit 2", Fault::program, {"status 7", "said on standard error"}, 2},
      {"lammps", "lammps 0", Fault::program, {"ERROR: Lost atoms", "last command: pair_style stub", "lammps/log"}, 0},
      {"broken", "broken 1", Fault::program, {"validate-atoms stopped: stub: broken as asked"}, 1},
      {"disk", "file 2", Fault::file, {"stub: cannot write"}, 2},
      {"style", "style 0", Fault::bad_input, {"stub: no such pair style"}, 0},
      {"good", "", Fault::program, {}, 3}};
  Jobs jobs;
  for (const Failing& f : all) jobs.add(f.name, f.orders);
  const auto outcomes = jobs.run(two_cores);
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(outcomes[i].finished, all[i].said.empty()) << all[i].name;
    EXPECT_EQ(outcomes[i].fault, all[i].fault) << all[i].name;
    for (const std::string& word : all[i].said)
      EXPECT_NE(outcomes[i].failure.find(word), std::string::npos) << word << " is not in: " << outcomes[i].failure;
    EXPECT_EQ(jobs.files(all[i].name), all[i].kept) << all[i].name;
  }
}

TEST(Jobs, TheUsersLauncherComesFirst) {
  Jobs jobs;
  jobs.add("a", "");
  const fs::path said = jobs.folder / "said";
  const AtomsLaunch launch{
      .program = STUB_ATOMS,
      .launcher = {"sh", "-c", "echo \"$0 $OMP_NUM_THREADS\" > " + said.string() + "; exec \"$@\"", "mine"},
      .cores = 1};
  EXPECT_TRUE(jobs.run(launch)[0].finished);
  EXPECT_EQ(jobs.folder.read("said"), "mine 1\n");
}

TEST(Jobs, AProgramThatIsMissingIsAnError) {
  Jobs jobs;
  jobs.add("a", "");
  EXPECT_THROW(jobs.run({.program = jobs.folder / "none", .launcher = {}, .cores = 1}), Error);
}

TEST(JobsDeathTest, ASignalStopsAllAndKeepsTheirSteps) {
  Jobs jobs;
  jobs.add("a", "sleep 200");
  jobs.add("b", "sleep 200");
  const auto run = [&] {
    catch_interrupts();
    try {
      run_jobs(two_cores, jobs.list, jobs.folder.path(), [](std::size_t, const atomistic::Event& event) {
        // One signal alone: a second ends the program at once, as it is meant to.
        if (std::holds_alternative<atomistic::StepEvent>(event) && !interrupted()) ::kill(::getpid(), SIGINT);
      });
    } catch (const Error& error) {
      ::_exit(static_cast<int>(error.exit_code()));
    }
    ::_exit(0);
  };
  EXPECT_EXIT(run(), testing::ExitedWithCode(130), "");
  EXPECT_EQ(jobs.files("a") + jobs.files("b") >= 1, true);
  EXPECT_LT(jobs.files("a") + jobs.files("b"), 6u);
}

TEST(Curves, TakeOverTheStepsThatAreThereAndKeepWhatCameBeforeAFailure) {
  const TemporaryFolder folder;
  Progress quiet(true);
  AtomsPath path{"disc", {}};
  path.problem.levels = {1, 2, 3, 4};
  path.problem.potential.pair_style = "stub linear 2 kill 2";
  const AtomsCurve cut = compute_curves(two_cores, {path}, 1, folder.path(), quiet)[0];
  EXPECT_EQ(cut.steps.size(), 2u);
  EXPECT_NE(cut.failure.find("atoms, disc load: "), std::string::npos);
  EXPECT_EQ(cut.failure_code, ExitCode::atomistic_failed);
  EXPECT_FALSE(cut.report);
  path.problem.potential.pair_style = "stub linear 3 kill 1";  // a step computed again would be met by the signal
  const AtomsCurve whole = compute_curves(two_cores, {path}, 1, folder.path(), quiet)[0];
  ASSERT_EQ(whole.steps.size(), 4u) << whole.failure;
  EXPECT_EQ(whole.failure, "");
  EXPECT_EQ(whole.lammps, "29 Sep 2021");
  EXPECT_DOUBLE_EQ(whole.steps[1].force_eV_per_A, 4);
  EXPECT_DOUBLE_EQ(whole.steps[2].force_eV_per_A, 9);
  ASSERT_TRUE(whole.report);
  EXPECT_EQ(whole.report->ended, atomistic::Ended::depth_max);
}

}  // namespace
