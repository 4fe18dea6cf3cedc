// Several cases in one command.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/cli/run_program.hpp"
#include "tests/support/json_schema.hpp"

namespace {

namespace fs = std::filesystem;
using cli_tests::Outcome;
using cli_tests::run_validate;
using cli_tests::WorkFolder;
using nlohmann::json;
using Words = std::vector<std::string>;

Words batch(const Words& more) {
  Words words = {"indentation",
                 "--potential",
                 "tersoff,tersoff-1989",
                 "--radius",
                 "12,15",
                 "--tip-radius",
                 "5",
                 "--loads",
                 "disc",
                 "--depth-step",
                 "1",
                 "--depth-max",
                 "3",
                 "--out",
                 "batch",
                 "--quiet"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

json document(const fs::path& file) {
  std::ifstream in(file);
  return json::parse(in);
}

TEST(Batch, RunsEveryPairInAFolderOfItsOwnAndCanBeResumed) {
  const WorkFolder folder;
  const Outcome outcome = run_validate(batch({}), folder.path());
  EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 3) << outcome.err;
  const json all = document(folder.path() / "batch" / "summary.json");
  EXPECT_EQ(support::JsonSchema(support::read_json(BATCH_SCHEMA)).problems(all), Words{});
  ASSERT_EQ(all["cases"].size(), 4u);
  const support::JsonSchema schema(support::read_json(SUMMARY_SCHEMA));
  for (const json& entry : all["cases"]) {
    EXPECT_EQ(schema.problems(entry["summary"]), Words{});
    EXPECT_EQ(entry["summary"]["case"]["radius_A"], entry["radius_A"]);
    EXPECT_EQ(entry["summary"]["case"]["potential"], entry["potential"]);
    EXPECT_EQ(entry["summary"],
              document(folder.path() / "batch" / entry["folder"].get<std::string>() / "summary.json"));
    EXPECT_NE(outcome.out.find(entry["potential"].get<std::string>()), std::string::npos);
  }

  const Outcome refused = run_validate(batch({}), folder.path());
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.err.find("--resume"), std::string::npos);

  const auto stamp = [&](const char* name) {
    return fs::last_write_time(folder.path() / "batch" / name / "summary.json");
  };
  const auto kept = stamp("tersoff-R12");
  fs::remove_all(folder.path() / "batch" / "tersoff-R15");
  const Outcome resumed = run_validate(batch({"--resume"}), folder.path());
  EXPECT_EQ(resumed.exit_code, outcome.exit_code) << resumed.err;
  EXPECT_EQ(stamp("tersoff-R12"), kept);
  EXPECT_TRUE(fs::exists(folder.path() / "batch" / "tersoff-R15" / "summary.json"));
}

TEST(Batch, ChecksEveryCaseBeforeTheFirstStarts) {
  const WorkFolder folder;
  const auto refused = [&](const Words& words, const char* said) {
    const Outcome outcome = run_validate(words, folder.path());
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find(said), std::string::npos) << outcome.err;
  };
  refused({"indentation", "--potential", "tersoff,tersof"}, "'tersoff'?");
  refused({"indentation", "--radius", "60,5"}, "too small");
  refused({"indentation", "--radius", "60,60"}, "named twice");
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(ReportCommand, MakesThePageAgainWithoutComputing) {
  const WorkFolder folder;
  const Words membrane = {"indentation", "--models",     "membrane", "--radius", "0.5 um",  "--E",    "1.0209 TPa",
                          "--thickness", "0.335 nm",     "--nu",     "0.165",    "--loads", "disc",   "--tip-radius",
                          "16.5 nm",     "--depth-step", "25 nm",    "--out",    "run",     "--quiet"};
  ASSERT_EQ(run_validate(membrane, folder.path()).exit_code, 0);
  const auto text = [&](const fs::path& file) {
    std::ifstream in(file);
    return std::string{std::istreambuf_iterator<char>(in), {}};
  };
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
