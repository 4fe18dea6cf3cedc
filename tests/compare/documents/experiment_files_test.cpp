#include "compare/documents/experiment_files.hpp"

#include <gtest/gtest.h>

#include "compare/base/errors.hpp"
#include "tests/compare/results/sample_result.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace validate;

namespace {

constexpr const char* documents[] = {"run.h5",          "curves.csv", "summary.json",    "figure.svg",
                                     "figure.png",      "figure.csv", "window_scan.svg", "window_scan.png",
                                     "window_scan.csv", "report.html"};

StudyOutcome outcome_of(Result result) {
  StudyOutcome outcome;
  outcome.result = std::move(result);
  return outcome;
}

TEST(ExperimentFiles, EveryDocumentIsWritten) {
  const TemporaryFolder folder;
  write_experiment(outcome_of(sample::full()), folder / "work", folder.path());
  for (const char* name : documents) EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
  EXPECT_EQ(folder.entries(), std::size(documents));
}

TEST(ExperimentFiles, OneThatFailsDoesNotStopTheOthers) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "run.h5/in the way");
  try {
    write_experiment(outcome_of(sample::full()), folder / "work", folder.path());
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.exit_code(), ExitCode::file_failed);
    EXPECT_NE(std::string(error.what()).find("run.h5"), std::string::npos);
  }
  for (const char* name : documents) EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
  EXPECT_EQ(folder.entries(), std::size(documents));
}

}  // namespace
