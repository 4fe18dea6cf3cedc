#include "compare/process/document_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "compare/process/run_folder.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace validate;

namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

Names entries(const fs::path& folder) {
  Names names;
  for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename().string());
  return names;
}

void put(const fs::path& file) { std::ofstream(file) << "something"; }

void write(const fs::path& out, const Names& documents, bool overwrite = false, int exit_code = 0) {
  OutputFolder folder(out, overwrite);
  for (const std::string& name : documents) put(folder.drafts() / name);
  folder.finish(exit_code);
}

TEST(OutputFolder, OverwriteTakesWhatWasWrittenBeforeAndNothingElse) {
  const TemporaryFolder parent;
  const fs::path out = parent / "a" / "fits";
  write(out, {"fit.json", "fit-one.svg"});
  put(out / "mine.csv");
  fs::create_directory(out / "work");  // the user's, as no run is here
  put(out / "work" / "case.txt");
  write(out, {"fit.json", "fit-two.svg"});  // beside what is there
  EXPECT_EQ(entries(out), (Names{".validate-run", "fit.json", "fit-one.svg", "fit-two.svg", "mine.csv", "work"}));
  write(out, {"figure1.svg"}, true);
  EXPECT_EQ(entries(out), (Names{".validate-run", "figure1.svg", "mine.csv", "work"}));
  EXPECT_TRUE(fs::exists(out / "work" / "case.txt"));
}

TEST(OutputFolder, ARunRefusesItAndReplacesItWhenAskedTo) {
  const TemporaryFolder parent;
  const fs::path out = parent / "out";
  write(out, {"verify.csv"}, false, 3);
  EXPECT_EQ(finished_exit_code(out), 3);
  RunOptions options;
  options.out = out;
  EXPECT_THROW(RunFolder(options, "unused", {{"radius_A", 20}}), Error);
  options.overwrite = true;
  RunFolder run(options, "unused", {{"radius_A", 20}});
  run.finish(ExitCode::success);
  EXPECT_EQ(entries(out), Names{".validate-run"});
}

TEST(OutputFolder, OfAKilledCommandIsNotTakenWithoutAsking) {
  const TemporaryFolder parent;
  const fs::path out = parent / "out";
  {
    OutputFolder folder(out, false);
    put(folder.drafts() / "figure1.svg");
    folder.publish();  // and no further
  }
  RunOptions options;
  options.out = out;
  EXPECT_THROW(RunFolder(options, "unused", {{"radius_A", 20}}), Error);
  EXPECT_TRUE(fs::exists(out / "figure1.svg"));
}

TEST(OutputFolder, LeavesARunsExitCodeAndItsUnfinishedWorkAlone) {
  const TemporaryFolder parent;
  const fs::path out = parent / "run";
  RunOptions options;
  options.out = out;
  {
    RunFolder run(options, "unused", {{"radius_A", 20}});
    put(run.drafts() / "summary.json");
    run.publish();
    EXPECT_THROW(OutputFolder(out, true), Error);  // in use
  }
  EXPECT_THROW(OutputFolder(out, true), Error);  // unfinished
  EXPECT_TRUE(is_resumable(out));
  options.resume = true;
  RunFolder(options, "unused", {{"radius_A", 20}}).finish(ExitCode::disagreement);
  write(out, {"fit.json"});
  EXPECT_EQ(finished_exit_code(out), static_cast<int>(ExitCode::disagreement));
}

}  // namespace
