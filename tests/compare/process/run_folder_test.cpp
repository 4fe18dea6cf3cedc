#include "compare/process/run_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "compare/base/file.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace validate;

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Names = std::set<std::string>;

enum class Asked { plain, resume, overwrite };

RunOptions options(const fs::path& out, Asked asked = Asked::plain) {
  RunOptions o;
  o.out = out;
  o.resume = asked == Asked::resume;
  o.overwrite = asked == Asked::overwrite;
  return o;
}

const Json a_case = {{"radius_A", 20}};

/// What the user sees: the record is hidden.
Names entries(const fs::path& folder) {
  Names names;
  for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename().string());
  names.erase(".validate-run");
  return names;
}

void put(const fs::path& file, const std::string& content = "mine") { std::ofstream(file) << content; }

void run(const fs::path& out, const Names& documents, Asked asked = Asked::plain, ExitCode code = ExitCode::success) {
  RunFolder folder(options(out, asked), "unused", a_case);
  for (const std::string& name : documents) put(folder.drafts() / name, "a document");
  folder.finish(code);
}

std::string refusal(const fs::path& out, Asked asked, const Json& identity = a_case) {
  try {
    RunFolder(options(out, asked), "unused", identity);
  } catch (const Error& error) {
    EXPECT_EQ(error.exit_code(), ExitCode::bad_input);
    return error.what();
  }
  return "";
}

TEST(RunFolder, OverwriteTakesWhatTheRunBeforeWroteAndNothingElse) {
  const TemporaryFolder parent;
  const fs::path out = parent / "run";
  run(out, {"run.h5", "membrane-disc-card.pvd", "membrane-disc-card-0.vtu", "summary.json"});
  put(out / "membrane-of-mine.vtu");
  fs::create_directory(out / "atoms-mine.data");
  run(out, {"run.h5", "summary.json", "figure.svg"}, Asked::overwrite);
  EXPECT_EQ(entries(out), (Names{"run.h5", "summary.json", "figure.svg", "membrane-of-mine.vtu", "atoms-mine.data"}));
}

TEST(RunFolder, ADocumentThatTheUserMadeAFolderOfStays) {
  const TemporaryFolder parent;
  const fs::path out = parent / "run";
  run(out, {"notes", "summary.json"});
  fs::remove(out / "notes");
  fs::create_directory(out / "notes");
  put(out / "notes" / "page");
  run(out, {"summary.json"}, Asked::overwrite);
  EXPECT_TRUE(fs::exists(out / "notes" / "page"));
}

TEST(RunFolder, ARecordFromOthersReachesNothingOutsideTheFolder) {
  const TemporaryFolder parent;
  const fs::path out = parent / "run";
  run(out, {"summary.json"});
  put(parent / "precious");
  fs::create_directories(parent / "other" / "work");
  fs::create_directory_symlink(parent / "other", out / "link");
  std::ofstream(out / ".validate-run", std::ios::app)
      << "file ../precious\nfile " << (parent / "precious").string() << "\nfolder ..\nfolder .\nfolder link\n";
  run(out, {"summary.json"}, Asked::overwrite);
  EXPECT_TRUE(fs::exists(parent / "precious"));
  EXPECT_TRUE(fs::exists(parent / "other" / "work"));
}

TEST(RunFolder, KeepsTheExitCodeOfAFinishedRun) {
  const TemporaryFolder parent;
  const fs::path out = parent / "run";
  EXPECT_EQ(finished_exit_code(out), std::nullopt);
  run(out, {"summary.json"}, Asked::plain, ExitCode::not_converged);
  EXPECT_EQ(finished_exit_code(out), 4);
  EXPECT_FALSE(is_resumable(out));
  { RunFolder again(options(out, Asked::overwrite), "unused", a_case); }
  EXPECT_EQ(finished_exit_code(out), std::nullopt);
  EXPECT_TRUE(is_resumable(out));
}

TEST(RunFolder, RefusesByWhatItHolds) {
  const TemporaryFolder parent;
  const fs::path done = parent / "done", half = parent / "half", other = parent / "other";
  run(done, {"summary.json"});
  { RunFolder(options(half), "unused", a_case); }
  fs::create_directory(other);
  put(other / "thesis.tex");
  EXPECT_NE(refusal(done, Asked::plain).find("finished run; --overwrite"), std::string::npos);
  EXPECT_NE(refusal(done, Asked::resume).find("finished run; --overwrite"), std::string::npos);
  EXPECT_NE(refusal(half, Asked::plain).find("unfinished run; --resume"), std::string::npos);
  EXPECT_NE(refusal(half, Asked::resume, {{"radius_A", 30}}).find("changed (radius_A)"), std::string::npos);
  for (const Asked asked : {Asked::plain, Asked::resume, Asked::overwrite})
    EXPECT_NE(refusal(other, asked).find("does not hold a run"), std::string::npos);
  EXPECT_NE(refusal(parent / "none", Asked::resume).find("no unfinished run"), std::string::npos);
  EXPECT_FALSE(fs::exists(parent / "none"));
  EXPECT_EQ(refusal(half, Asked::resume), "");
  EXPECT_EQ(refusal(half, Asked::overwrite), "");
}

TEST(RunFolder, IsInUseWhileItLives) {
  const TemporaryFolder parent;
  const RunFolder first(options(parent / "run"), "unused", a_case);
  for (const Asked asked : {Asked::resume, Asked::overwrite})
    EXPECT_NE(refusal(parent / "run", asked).find("in use"), std::string::npos);
  EXPECT_TRUE(is_resumable(parent / "run"));
}

/// Each state in which a kill can leave a folder before the case is kept; each way of starting works on each.
TEST(RunFolder, KilledBeforeItsCaseWasKeptIsUsable) {
  for (const int state : {0, 1, 2, 3})
    for (const Asked asked : {Asked::plain, Asked::resume, Asked::overwrite}) {
      const TemporaryFolder parent;
      const fs::path out = parent / "run";
      fs::create_directories(out / "work");
      if (state == 3) fs::remove(out / "work");
      if (state == 1) put(out / "work" / ".case.json.4711-0.tmp", "{");
      if (state == 2) {  // an --overwrite beside a file of the user's
        fs::remove(out / "work");
        run(out, {"summary.json"});
        put(out / "notes.txt");
        clear_run(out);
      }
      run(out, {"summary.json"}, asked);
      EXPECT_EQ(finished_exit_code(out), 0);
      EXPECT_EQ(entries(out), state == 2 ? (Names{"summary.json", "notes.txt"}) : Names{"summary.json"});
    }
  const TemporaryFolder parent;
  fs::create_directories(parent / "mine" / "work");
  put(parent / "mine" / "work" / "chapter.tex");
  EXPECT_NE(refusal(parent / "mine", Asked::overwrite).find("does not hold a run"), std::string::npos);
}

/// A kill between the names and the files, and one after: a new start leaves nothing of either.
TEST(RunFolder, AKillWhilePublishingLeavesNothingUnknown) {
  const TemporaryFolder parent;
  const fs::path out = parent / "run";
  {
    RunFolder folder(options(out), "unused", a_case);
    put(folder.drafts() / "first");
    put(folder.drafts() / "second");
    fs::create_directory(out / "first");  // in the way: what a kill before its turn leaves
    put(out / "first" / "mine");
    EXPECT_THROW(folder.publish(), Error);
    EXPECT_TRUE(fs::is_regular_file(out / "second")) << "one that fails does not keep the others";
  }
  EXPECT_TRUE(is_resumable(out));
  const auto record = read_record(out);
  ASSERT_TRUE(record);
  EXPECT_EQ(Names(record->files.begin(), record->files.end()), (Names{"first", "second"}));
  run(out, {"third"}, Asked::overwrite);
  EXPECT_EQ(entries(out), (Names{"first", "third"}));
}

TEST(RunFolder, ResumingForgetsHalfWrittenDraftsAndKnowsTheFilesOfTheTryBefore) {
  const TemporaryFolder parent;
  const fs::path out = parent / "run";
  {
    RunFolder failed(options(out), "unused", a_case);
    put(failed.drafts() / "lammps.log");
    failed.publish();
    put(failed.drafts() / ".run.h5.4711-0.tmp");
  }
  run(out, {"summary.json"}, Asked::resume);
  EXPECT_EQ(entries(out), (Names{"summary.json", "lammps.log"}));
  run(out, {"summary.json"}, Asked::overwrite);
  EXPECT_EQ(entries(out), Names{"summary.json"});
}

TEST(RunFolder, ThatWasNotUsedLeavesNoTrace) {
  const TemporaryFolder parent;
  RunFolder(options(parent / "deep" / "run"), "unused", a_case).remove_if_unused();
  EXPECT_EQ(parent.entries(), 0u);
  RunFolder used(options(parent / "run"), "unused", a_case);
  put(used.work() / "step");
  used.remove_if_unused();
  EXPECT_TRUE(fs::exists(parent / "run" / "work" / "step"));
}

TEST(RunFolder, ABatchIsClearedWithTheRunsBelowIt) {
  const TemporaryFolder parent;
  const fs::path batch = parent / "batch";
  run(batch / "done", {"summary.json"});
  run(batch / "noted", {"summary.json"});
  put(batch / "noted" / "notes.txt");
  { RunFolder(options(batch / "half"), "unused", a_case); }
  fs::create_directories(batch / "mine" / "work" / "deep");
  put(batch / "summary.json", "table");
  write_record(batch, {.files = {"summary.json"}, .folders = {"done", "noted", "half", "mine"}, .exit_code = 0});
  clear_run(batch);
  EXPECT_EQ(entries(batch), (Names{"noted", "mine"}));
  EXPECT_EQ(entries(batch / "noted"), Names{"notes.txt"});
  EXPECT_TRUE(fs::exists(batch / "mine" / "work" / "deep")) << "no run of this program";
}

TEST(RunFolder, KnowsWhatIsWrittenAfterItsRun) {
  const TemporaryFolder parent;
  const fs::path out = parent / "run";
  run(out, {"summary.json"}, Asked::plain, ExitCode::disagreement);
  add_to_record(out / "report.html");
  put(out / "report.html", "a page");
  EXPECT_EQ(finished_exit_code(out), 3);
  run(out, {"summary.json"}, Asked::overwrite);
  EXPECT_EQ(entries(out), Names{"summary.json"});
  add_to_record(parent / "report.html");  // no run's folder
  EXPECT_EQ(entries(parent.path()), Names{"run"});
}

TEST(RunFolder, OfAnEarlierVersionIsAFinishedRun) {
  const TemporaryFolder parent;
  fs::create_directory(parent / "run");
  put(parent / "run" / "summary.json");
  EXPECT_NE(refusal(parent / "run", Asked::plain).find("finished run"), std::string::npos);
  run(parent / "run", {"summary.json"}, Asked::overwrite);
  EXPECT_EQ(finished_exit_code(parent / "run"), 0);
}

TEST(RunFolder, OfManyThatAskAtOnceEachGetsItsOwn) {
  const TemporaryFolder parent;
  const auto numbered = [&](int number) { return parent / "runs" / ("x-" + std::to_string(number)); };
  std::vector<std::thread> askers;
  std::vector<fs::path> got(8);
  for (fs::path& one : got) askers.emplace_back([&] { one = make_numbered_folder(numbered).path; });
  for (std::thread& asker : askers) asker.join();
  EXPECT_EQ(std::set<fs::path>(got.begin(), got.end()).size(), got.size());
  EXPECT_EQ(make_numbered_folder(numbered).path, parent / "runs" / "x-9");
}

}  // namespace
