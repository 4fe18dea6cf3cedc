// validate bulge with the same sheet as atoms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/cli/run_support.hpp"

namespace {

namespace fs = std::filesystem;
using namespace cli_tests;
using nlohmann::json;

Words bulge(const Words& more) {
  Words words = {"bulge", "--potential", "tersoff", "--size", "50", "--cells", "16", "--out", "run"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// Bending keeps the atoms below the membrane, less and less as the tension grows; all of the sheet is taut.
TEST(BulgeAtoms, AClampedDiscApproachesItsMembrane) {
  const WorkFolder folder;
  const Outcome outcome =
      run_validate(bulge({"--shape", "disc", "--edge", "clamped", "--pressures", "1e-3,4e-3,1.6e-2"}), folder.path());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json summary = document(folder.path() / "run" / "summary.json");
  const json& atoms = summary["atoms"];
  ASSERT_EQ(atoms["points"].size(), 3u);
  const double bond = atoms["card"]["a0_A"].get<double>() / std::sqrt(3.0);
  EXPECT_NEAR(atoms["membrane_size_x_A"].get<double>(), 50 + 1.5 * bond, 1e-9);
  EXPECT_NEAR(summary["case"]["E_eV_per_A3"].get<double>() * 1.37, atoms["card"]["Eh_eV_per_A2"].get<double>(), 1e-9);
  double before = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const json& point = atoms["points"][i];
    EXPECT_EQ(point["membrane_depth_A"], summary["points"][i]["depth_A"]);
    const double ratio = point["depth_ratio"];
    EXPECT_GT(ratio, before);
    EXPECT_LT(ratio, 1.02);
    EXPECT_TRUE(point["converged"].get<bool>());
    EXPECT_LT(point["balance_relative"].get<double>(), 1e-2);
    before = ratio;
  }
  EXPECT_GT(before, 0.95);
  for (const char* name :
       {"atoms.csv", "atoms.svg", "atoms.png", "atoms-figure.csv", "atoms-pressure.extxyz", "lammps.log"})
    EXPECT_GT(fs::file_size(folder.path() / "run" / name), 100u) << name;
  EXPECT_NE(outcome.out.find("atoms' depth"), std::string::npos);
}

/// Without a fitted number: the potential's own law, and bending. What is left falls with the radius, as a quarter of a
/// bond in it would make it.
TEST(BulgeAtoms, AClampedDiscIsItsCalibratedSheet) {
  double before = 1;
  for (const char* size : {"50", "120"}) {
    const WorkFolder folder;
    const Outcome outcome =
        run_validate({"bulge", "--potential", "tersoff", "--shape", "disc", "--edge", "clamped", "--size", size,
                      "--cells", "16", "--pressures", "1e-3,1.6e-2", "--out", "run"},
                     folder.path());
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json summary = document(folder.path() / "run" / "summary.json");
    ASSERT_EQ(summary["atoms"]["points"].size(), 2u);
    double worst = 0;
    for (const json& point : summary["atoms"]["points"])
      worst = std::max(worst, std::abs(point["sheet_ratio"].get<double>() - 1));
    EXPECT_GT(worst, 0);
    EXPECT_LT(worst, 0.5 * before);
    before = worst;
  }
  EXPECT_LT(before, 0.01);
}

/// The membrane's edges lie where the outermost atoms are.
TEST(BulgeAtoms, ASquareThatSlidesComesInAndStaysInItsPlane) {
  const WorkFolder folder;
  const Outcome outcome = run_validate(bulge({"--pressures", "2e-3"}), folder.path());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json summary = document(folder.path() / "run" / "summary.json");
  for (const char* side : {"membrane_size_x_A", "membrane_size_y_A"}) {
    EXPECT_LE(summary["atoms"][side].get<double>(), 50);
    EXPECT_GT(summary["atoms"][side].get<double>(), 50 - 2 * 2.5);
  }
  // Without stretch the membrane inflates to a quarter of its side; bending forbids the atoms the folds that this
  // takes.
  EXPECT_LT(summary["atoms"]["points"][0]["depth_ratio"].get<double>(), 0.5);
}

TEST(BulgeAtoms, BadInputIsNamedAndLeavesNothing) {
  const WorkFolder folder;
  expect_says(run_validate(bulge({"--E", "3"}), folder.path()), 2, {"--E", "card"});
  const auto of_size = [&](const char* size) {
    Words words = bulge({"--pressures", "1e-3"});
    words[4] = size;
    return run_validate(words, folder.path());
  };
  expect_says(of_size("5000"), 2, {"--size", "too large", "2000"});
  expect_says(of_size("8"), 2, {"size", "lattice"});
  Words unknown = bulge({});
  unknown[2] = "tersof";
  expect_says(run_validate(unknown, folder.path()), 2, {"--potential", "tersoff"});
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

}  // namespace
