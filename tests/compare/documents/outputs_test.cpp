#include "compare/documents/outputs.hpp"

#include <gtest/gtest.h>

#include "compare/base/errors.hpp"
#include "tests/compare/results/sample_result.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace validate;

TEST(Outputs, WritesEveryDocument) {
  const TemporaryFolder folder;
  write_all(sample::full(), folder.path());
  for (const char* name : {"run.h5", "curves.csv", "summary.json", "figure.svg", "figure.png", "figure.csv",
                           "window_scan.svg", "window_scan.png", "window_scan.csv"}) {
    EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
  }
  EXPECT_EQ(folder.entries(), 9u);
}

TEST(Outputs, OneThatFailsDoesNotStopTheOthers) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "run.h5/in the way");
  try {
    write_all(sample::full(), folder.path());
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.exit_code(), ExitCode::file_failed);
    EXPECT_NE(std::string(error.what()).find("run.h5"), std::string::npos);
  }
  for (const char* name : {"curves.csv", "summary.json", "figure.svg", "figure.png", "figure.csv", "window_scan.svg",
                           "window_scan.png", "window_scan.csv"}) {
    EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
  }
  EXPECT_EQ(folder.entries(), 9u);
}
