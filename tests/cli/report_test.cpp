// `validate report`: the page of a finished run, from its run.h5 alone.
#include <gtest/gtest.h>

#include <fstream>

#include "tests/cli/run_support.hpp"

namespace {

using namespace cli_tests;
namespace fs = std::filesystem;

std::string text(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The page made of a folder is there, and says these words.
void expect_page(const WorkFolder& folder, const std::string& run, const Words& words) {
  fs::remove(folder.path() / run / "report.html");
  const Outcome outcome = run_validate({"report", run}, folder.path());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string page = text(folder.path() / run / "report.html");
  for (const std::string& word : words) EXPECT_NE(page.find(word), std::string::npos) << word;
}

TEST(ReportCommand, OfABulge) {
  const WorkFolder folder;
  ASSERT_EQ(run_validate({"bulge", "--cells", "8", "--out", "run", "--quiet"}, folder.path()).exit_code, 0);
  expect_page(folder, "run", {"pressure", "data:image/png", "validate bulge --cells 8"});
}

TEST(ReportCommand, OfAFit) {
  const WorkFolder folder;
  ASSERT_EQ(run_validate(
                {"fit", std::string(SOURCE_INPUTS) + "/measured/synthetic-034.csv", "--bootstrap", "0", "--out", "fit"},
                folder.path())
                .exit_code,
            0);
  expect_page(folder, "fit", {"synthetic-034.csv", "eq16", "<svg"});
}

TEST(ReportCommand, OfABatch) {
  const WorkFolder folder;
  ASSERT_EQ(
      run_validate({"indentation", "--models", "membrane", "--radius", "40,50", "--E",          "1", "--thickness",
                    "1",           "--nu",     "0.3",      "--loads",  "disc",  "--tip-radius", "5", "--depth-step",
                    "2",           "--out",    "batch",    "--quiet"},
                   folder.path())
          .exit_code,
      0);
  expect_page(folder, "batch", {"R40", "R50"});
}

TEST(ReportCommand, MakesThePageAgainWithoutComputing) {
  const WorkFolder folder;
  const Words membrane = {"indentation", "--models",     "membrane", "--radius", "0.5 um",  "--E",    "1.0209 TPa",
                          "--thickness", "0.335 nm",     "--nu",     "0.165",    "--loads", "disc",   "--tip-radius",
                          "16.5 nm",     "--depth-step", "25 nm",    "--out",    "run",     "--quiet"};
  ASSERT_EQ(run_validate(membrane, folder.path()).exit_code, 0);
  const std::string before = text(folder.path() / "run" / "report.html");
  ASSERT_FALSE(before.empty());
  fs::remove(folder.path() / "run" / "report.html");
  EXPECT_EQ(run_validate({"report", "run/run.h5"}, folder.path()).exit_code, 0);
  EXPECT_EQ(text(folder.path() / "run" / "report.html"), before);
  EXPECT_EQ(run_validate({"report", "run", "--out", "page.html"}, folder.path()).exit_code, 0);
  EXPECT_EQ(text(folder.path() / "page.html"), before);
  const Outcome refused = run_validate({"report", "run/summary.json"}, folder.path());
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.err.find("not an HDF5 file"), std::string::npos);
}

}  // namespace
