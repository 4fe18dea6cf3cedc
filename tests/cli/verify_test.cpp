// `validate verify` from outside. That every group passes is a test of its own in CMakeLists.txt.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/cli/run_support.hpp"

namespace {

using cli_tests::Outcome;
using cli_tests::run_validate;
using cli_tests::WorkFolder;
using nlohmann::json;

TEST(VerifyCommand, WritesTheRowsAsTableCsvAndJson) {
  const WorkFolder folder;
  const Outcome outcome = run_validate(
      {"verify", "membrane", "--group", "patch", "--out", "out", "--json", "rows.json", "--wide"}, folder.path());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.err.find("patch: "), std::string::npos) << outcome.err;
  std::ifstream file(folder.path() / "rows.json");
  const json document = json::parse(file);
  cli_tests::expect_valid(document, "verify");
  EXPECT_EQ(document["command"], "verify");
  const auto rows = document["rows"].size();
  EXPECT_GE(rows, 20u);
  EXPECT_EQ(document["passed"], rows);
  EXPECT_EQ(document["failed"], 0);
  bool sheared = false;
  for (const json& row : document["rows"]) {
    EXPECT_TRUE(row["pass"]);
    EXPECT_FALSE(row["source"].get<std::string>().empty());
    if (row["quantity"] == "S1/Eh" && row["name"] == "simple shear 0.1, wrinkled") {
      sheared = true;
      EXPECT_NEAR(row["ours"].get<double>(), 0.0525625, 1e-7);
    }
  }
  EXPECT_TRUE(sheared);
  EXPECT_GT(document["outside"], 0);
  EXPECT_EQ(document["outside"].get<std::size_t>() + document["itself"].get<std::size_t>(), rows);
  EXPECT_NE(outcome.out.find("check the code against itself"), std::string::npos);
  std::ifstream csv(folder.path() / "out" / "verify.csv");
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(line, "group,name,quantity,ours,relation,published,source,basis,relative_error,tolerance,pass,note");
  std::size_t lines = 0;
  while (std::getline(csv, line)) ++lines;
  EXPECT_EQ(lines, rows);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "out" / "verify.json"));
  EXPECT_NE(outcome.out.find("closed form: (l1^2-1)/2"), std::string::npos) << "origins are printed with --wide";
}

TEST(VerifyCommand, JsonOnStdoutIsNothingElse) {
  const WorkFolder folder;
  const Outcome outcome =
      run_validate({"verify", "membrane", "--group", "laws", "--json", "-", "--quiet"}, folder.path());
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(json::parse(outcome.out)["failed"], 0);
  EXPECT_EQ(outcome.err, "");
}

TEST(VerifyCommand, BadInputIsNamed) {
  const WorkFolder folder;
  const auto expect = [&](const std::vector<std::string>& words, const char* said) {
    const Outcome outcome = run_validate(words, folder.path());
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find(said), std::string::npos) << outcome.err;
  };
  expect({"verify", "membrane", "--group", "pont"}, "did you mean 'point'?");
  expect({"verify", "membran"}, "did you mean 'membrane'?");
  expect({"verify", "atoms", "--group", "force"}, "did you mean 'forces'?");
  expect({"verify", "membrane", "--potential", "tersoff"}, "--potential");
  expect({"verify"}, "what");
  expect({"verify", "membrane", "--break", "half-shear"}, "unknown flag '--break'");  // in test builds only
}

}  // namespace
