// `validate potential` from outside.
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>

#include "tests/cli/run_support.hpp"

namespace {

using namespace cli_tests;
namespace fs = std::filesystem;
using nlohmann::json;

/// Each test has a cache of its own.
class PotentialCommand : public testing::Test {
 protected:
  Outcome run(const Words& words) {
    Words all = {"potential"};
    all.insert(all.end(), words.begin(), words.end());
    return run_validate(all, folder_.path(), {"XDG_CACHE_HOME=" + cache()});
  }
  std::string cache() const { return (cache_.path() / "cache").string(); }
  WorkFolder folder_, cache_;
};

TEST_F(PotentialCommand, PrintsTheCardAndLeavesNothing) {
  const Outcome outcome = run({"tersoff"});
  expect_says(outcome, 0, {});
  for (const char* word : {"2.492049 Å", "354.87 N/m", "22.1", "zigzag", "armchair", "equibiaxial", "strength"})
    EXPECT_NE(outcome.out.find(word), std::string::npos) << word << " is not in\n" << outcome.out;
  EXPECT_TRUE(fs::is_empty(folder_.path()));
}

TEST_F(PotentialCommand, WritesFilesAndJson) {
  const Outcome outcome = run({"tersoff", "--out", "card", "--json", "-"});
  expect_says(outcome, 0, {});
  const json card = json::parse(outcome.out);
  EXPECT_NEAR(card["Eh_N_per_m"].get<double>(), 354.9, 0.5);
  EXPECT_NEAR(card["Eh_N_per_m"].get<double>() / card["Eh_eV_per_A2"].get<double>(), 16.02176634, 1e-9);
  EXPECT_NEAR(card["nu"].get<double>(), 0.065, 1e-3);
  EXPECT_NEAR(card["bending_modulus_zigzag_eV"].get<double>(), 1.865, 0.05 * 1.865);
  EXPECT_TRUE(card["gaussian_modulus_eV"].is_null());
  ASSERT_EQ(card["curves"].size(), 3u);
  for (const json& curve : card["curves"]) {
    EXPECT_GT(curve["secant_at_2_percent_N_per_m"].get<double>(), curve["secant_at_10_percent_N_per_m"].get<double>());
    EXPECT_EQ(curve["strain"].size(), curve["stress_eV_per_A2"].size());
  }
  EXPECT_EQ(card["states"]["E11"].size(), 176u);
  expect_valid(card, "card");
  EXPECT_EQ(card["law"]["coefficient_eV_per_A2"].size(), 33u);
  EXPECT_LT(card["law"]["worst_misfit"].get<double>(), 1e-3);
  EXPECT_TRUE(card["law"]["convex"].get<bool>());
  EXPECT_EQ(card["potential"]["sha256"].get<std::string>().size(), 64u);
  const Outcome report = run_validate({"report", "card"}, folder_.path());
  EXPECT_EQ(report.exit_code, 0) << report.err;
  for (const char* name : {"card.json", "run.h5", "report.html", "law.toml", "stress-strain.csv", "stress-strain.svg",
                           "stress-strain.png"})
    EXPECT_GT(fs::file_size(folder_.path() / "card" / name), 1000u) << name;
  EXPECT_EQ(document(folder_.path() / "card/card.json"), card);
}

/// The second run reads what the first has kept, and writes nothing; what has been changed since is computed again.
TEST_F(PotentialCommand, KeepsTheCardByHash) {
  const Outcome first = run({"tersoff", "--json", "-"});
  ASSERT_EQ(first.exit_code, 0) << first.err;
  std::vector<fs::path> kept;
  for (const auto& entry : fs::recursive_directory_iterator(cache()))
    if (entry.is_regular_file()) kept.push_back(entry.path());
  ASSERT_EQ(kept.size(), 1u);
  const auto a0_of = [&](const Words& more) {
    Words words = {"tersoff", "--json", "-"};
    words.insert(words.end(), more.begin(), more.end());
    return json::parse(run(words).out)["a0_A"].get<double>();
  };
  const double a0 = json::parse(first.out)["a0_A"];
  const auto written = fs::last_write_time(kept[0]);
  EXPECT_EQ(a0_of({}), a0);
  EXPECT_EQ(fs::last_write_time(kept[0]), written) << "read from the cache";
  EXPECT_EQ(a0_of({"--refresh"}), a0);
  EXPECT_NE(fs::last_write_time(kept[0]), written);
  json changed = document(kept[0]);
  changed["card"]["a0_A"] = 2.5;
  for (const std::string& text : {changed.dump(), std::string("{ broken"), std::string("{\"sha256\": 1}")}) {
    std::ofstream(kept[0]) << text;
    EXPECT_EQ(a0_of({}), a0);
  }
}

TEST_F(PotentialCommand, RefusesWhatItCannotUse) {
  expect_says(run({"terzoff"}), 2, {"unknown potential 'terzoff'", "did you mean 'tersoff'?"});
  expect_says(run({}), 2, {"NAME"});
  expect_says(run({"tersoff", "--switch-length", "1.92", "--out", "x"}), 2, {"--switch-length", "no switch"});
  expect_says(run({"rebo", "--switch-length", "3", "--out", "x"}), 2, {"--switch-length", "1.99"});
  expect_says(run({"rebo", "--switch-length", "1.92"}), 2, {"--out"});
  EXPECT_TRUE(fs::is_empty(folder_.path()));
}

/// The copy differs in the one number, says so, and moves the artefact; the small-strain moduli stay.
TEST_F(PotentialCommand, MovesTheSwitchInACopy) {
  const Outcome moved = run({"rebo", "--switch-length", "1.92", "--out", "rebo-1.92", "--json", "-"});
  ASSERT_EQ(moved.exit_code, 0) << moved.err;
  const json with = json::parse(moved.out), without = json::parse(run({"rebo", "--json", "-"}).out);
  EXPECT_NEAR(with["Eh_eV_per_A2"].get<double>(), without["Eh_eV_per_A2"].get<double>(), 1e-6);
  EXPECT_EQ(with["potential"]["artefact_bond_A"], 1.92);
  EXPECT_EQ(with["potential"]["sha256"], without["potential"]["sha256"]);
  const std::string edit = with["potential"]["edit"];
  for (const char* word : {"rcmin_CC", "1.7", "1.92", "switched-CH.rebo"})
    EXPECT_NE(edit.find(word), std::string::npos) << edit;
  std::ifstream original(fs::path(LAMMPS_POTENTIALS_DIR) / "CH.rebo"),
      copy(folder_.path() / "rebo-1.92/switched-CH.rebo");
  int different = 0;
  std::string a, b;
  while (std::getline(original, a) && std::getline(copy, b)) different += a != b;
  EXPECT_EQ(different, 1);
}

}  // namespace
