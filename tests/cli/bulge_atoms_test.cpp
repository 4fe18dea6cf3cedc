// validate bulge with the same sheet as atoms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

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

/// Depths of the atoms over those of a continuum at the same pressures.
std::vector<double> depth_ratios(const json& summary, const char* model, const char* constants) {
  const json &atoms = run_of(summary, "atomistic", "pressure"),
             &continuum = run_of(summary, model, "pressure", constants);
  EXPECT_EQ(atoms["pressure_eV_per_A3"].size(), continuum["pressure_eV_per_A3"].size());
  std::vector<double> ratios;
  for (std::size_t i = 0; i < atoms["depth_A"].size(); ++i) {
    EXPECT_NEAR(atoms["pressure_eV_per_A3"][i].get<double>(), continuum["pressure_eV_per_A3"][i].get<double>(), 1e-12);
    ratios.push_back(atoms["depth_A"][i].get<double>() / continuum["depth_A"][i].get<double>());
  }
  return ratios;
}

/// Bending keeps the atoms below the membrane, less and less as the tension grows; all of the sheet is taut.
TEST(BulgeAtoms, AClampedDiscApproachesItsMembrane) {
  const WorkFolder folder;
  const Outcome outcome =
      run_validate(bulge({"--shape", "disc", "--edge", "clamped", "--pressures", "1e-3,4e-3,1.6e-2"}), folder.path());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json summary = document(folder.path() / "run" / "summary.json");
  expect_valid(summary);
  const json &atoms = run_of(summary, "atomistic", "pressure"),
             &membrane = run_of(summary, "membrane", "pressure", "card");
  // The free atoms' area and the lattice's margin: somewhat less than half a bond beyond it.
  const double bond = summary["card"]["a0_A"].get<double>() / std::sqrt(3.0);
  const double area = summary["sheet"]["free_atoms"].get<double>() * 3 * std::sqrt(3.0) / 4 * bond * bond;
  EXPECT_NEAR((membrane["a_A"].get<double>() - std::sqrt(area / std::numbers::pi)) / bond, 0.45, 0.1);
  EXPECT_EQ(membrane["Eh_eV_per_A2"], summary["card"]["Eh_eV_per_A2"]);
  EXPECT_EQ(membrane["nu"], summary["card"]["nu"]);
  const std::vector<double> ratios = depth_ratios(summary, "membrane", "card");
  ASSERT_EQ(ratios.size(), 3u);
  double before = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_GT(ratios[i], before);
    EXPECT_LT(ratios[i], 1.02);
    EXPECT_TRUE(atoms["converged"][i].get<bool>());
    EXPECT_LT(atoms["balance_relative"][i].get<double>(), 1e-2);
    before = ratios[i];
  }
  EXPECT_GT(before, 0.95);
  for (const char* name : {"atoms.csv", "atoms.svg", "atoms.png", "curves.csv", "atoms-pressure.extxyz", "lammps.log"})
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
    const std::vector<double> ratios = depth_ratios(summary, "sheet", "calibrated");
    ASSERT_EQ(ratios.size(), 2u);
    double worst = 0;
    for (const double ratio : ratios) worst = std::max(worst, std::abs(ratio - 1));
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
  const double side = 2 * run_of(summary, "membrane", "pressure", "card")["a_A"].get<double>();
  EXPECT_LE(side, 50);
  EXPECT_GT(side, 50 - 2 * 2.5);
  // Without stretch the membrane inflates to a quarter of its side; bending forbids the atoms the folds that this
  // takes.
  EXPECT_LT(depth_ratios(summary, "membrane", "card").at(0), 0.5);
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
