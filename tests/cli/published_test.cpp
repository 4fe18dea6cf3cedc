// `validate published` from outside; rows that need no potential.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/cli/run_support.hpp"

namespace {

using cli_tests::Outcome;
using cli_tests::run_validate;
using cli_tests::WorkFolder;
using nlohmann::json;

void write(const std::filesystem::path& file, const std::string& text) { std::ofstream(file) << text; }

const std::string row_of_mine =
    "[[row]]\nname = \"my bulge\"\nquantity = \"hencky\"\nnu = 0.3\npublished = 0.66\nuncertainty = 0.01\nunit = "
    "\"1\"\n"
    "conditions = \"a drum\"\ncomparable = true\nsource = \"lab book\"\n";

TEST(PublishedCommand, PutsOursBesideEveryRow) {
  const WorkFolder folder;
  write(folder.path() / "mine.toml", row_of_mine);
  const Outcome outcome = run_validate({"published", "--file", "mine.toml", "--only", "Hencky", "--only", "my bulge",
                                        "--out", "out", "--json", "rows.json", "--quiet"},
                                       folder.path());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("Hencky 1915"), std::string::npos) << outcome.out;
  std::ifstream file(folder.path() / "rows.json");
  const json document = json::parse(file);
  cli_tests::expect_valid(document, "published");
  EXPECT_EQ(document["schema"], 2);
  ASSERT_EQ(document["rows"].size(), 3u);
  for (const json& row : document["rows"]) EXPECT_NEAR(row["ours"].get<double>(), row["published"].get<double>(), 0.01);
  const json& mine = document["rows"][2];
  EXPECT_EQ(mine["name"], "my bulge");
  EXPECT_NEAR(mine["z"].get<double>(), (0.653449 - 0.66) / 0.01, 1e-2);
  EXPECT_TRUE(mine["comparable"].get<bool>());
  EXPECT_TRUE(document["rows"][0]["uncertainty"].is_null());
  EXPECT_TRUE(document["rows"][0]["z"].is_null());
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "out" / "published.csv"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "out" / "published.json"));
}

/// A number far off is no failure: it is a comparison.
TEST(PublishedCommand, EndsWellHoweverFarOff) {
  const WorkFolder folder;
  std::string wrong = row_of_mine;
  write(folder.path() / "mine.toml", wrong.replace(wrong.find("0.66"), 4, "6.6"));
  const Outcome outcome = run_validate({"published", "--file", "mine.toml", "--only", "my", "--quiet"}, folder.path());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("z = -594"), std::string::npos) << outcome.out;
}

TEST(PublishedCommand, BadInputIsNamed) {
  const WorkFolder folder;
  const auto expect = [&](const std::vector<std::string>& words, const char* said) {
    const Outcome outcome = run_validate(words, folder.path());
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find(said), std::string::npos) << outcome.err;
  };
  expect({"published", "--only", "Henky"}, "--only");
  std::string wrong = row_of_mine;
  write(folder.path() / "mine.toml", wrong.replace(wrong.find("hencky"), 6, "henky"));
  expect({"published", "--file", "mine.toml"}, "did you mean 'hencky'?");
  expect({"published", "--file", "missing.toml"}, "missing.toml");
}

}  // namespace
