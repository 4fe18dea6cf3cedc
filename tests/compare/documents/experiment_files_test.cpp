#include "compare/documents/experiment_files.hpp"

#include <gtest/gtest.h>

#include "compare/base/errors.hpp"
#include "tests/compare/results/sample_result.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace validate;

namespace {

const std::vector<std::string>& documents() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> names = {"run.h5", "curves.csv", "summary.json", "report.html", "figure-narrow.pdf"};
    for (const char* picture : {"figure", "ratio", "explanation", "window_scan"})
      for (const char* ending : {".svg", ".png", ".pdf", ".csv"}) names.push_back(std::string(picture) + ending);
    return names;
  }();
  return all;
}

StudyOutcome outcome_of(Result result) {
  StudyOutcome outcome;
  outcome.result = std::move(result);
  return outcome;
}

TEST(ExperimentFiles, EveryDocumentIsWritten) {
  const TemporaryFolder folder;
  write_experiment(outcome_of(sample::full()), folder / "work", folder.path());
  for (const std::string& name : documents()) EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
  EXPECT_EQ(folder.entries(), documents().size());
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
  for (const std::string& name : documents()) EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
  EXPECT_EQ(folder.entries(), documents().size());
}

}  // namespace
