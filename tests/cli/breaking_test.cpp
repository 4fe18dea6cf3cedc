// A run to the end: the switch out of the way of fracture, atoms and sheet until both break.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/cli/run_support.hpp"

namespace {

using namespace cli_tests;
using nlohmann::json;

TEST(Breaking, AtomsAndSheetAreFollowedUntilBothBreak) {
  const WorkFolder folder;
  const Outcome outcome =
      run_validate({"indentation", "--potential", "rebo", "--radius", "20", "--loads", "disc", "--switch-length",
                    "1.92", "--depth-max", "11", "--depth-step", "1", "--out", "run"},
                   folder.path());
  const json summary = document(folder.path() / "run" / "summary.json");
  expect_valid(summary);
  const json &atoms = run_of(summary, "atomistic", "disc"), &sheet = run_of(summary, "sheet", "disc", "calibrated");
  EXPECT_EQ(atoms["ended"], "rupture");
  EXPECT_EQ(sheet["ended"], "rupture");
  const json& breaking = summary["agreement"]["breaking"];
  EXPECT_EQ(breaking, atoms["breaking"]);
  const double force = breaking["force_eV_per_A"], lower = breaking["bracket"][0], upper = breaking["bracket"][1];
  EXPECT_DOUBLE_EQ(lower, force);
  EXPECT_LE(upper, 1.01 * lower);
  EXPECT_NEAR(force, 81.4, 0.01 * 81.4);  // of steps of 0.5 Å
  EXPECT_FALSE(breaking["past_artefact"].get<bool>());
  EXPECT_LT(breaking["depth_A"].get<double>(), breaking["depth_bracket_A"][1].get<double>());
  // The sheet's end is the potential's own law's, 3 % below for a tip of 10 Å.
  EXPECT_NEAR(breaking["sheet_force_eV_per_A"].get<double>() / force, 0.97, 0.01);
  EXPECT_NEAR(breaking["sheet_depth_A"].get<double>() / breaking["depth_A"].get<double>(), 0.97, 0.015);
  int judged = 0;
  const json& comparison = summary["comparison"][0];
  for (std::size_t i = 0; i < comparison["sheet_ratio"].size(); ++i) {
    if (comparison["sheet_ratio"][i].is_null() || comparison["depth_relative"][i] < 0.03) continue;
    EXPECT_NEAR(comparison["sheet_ratio"][i].get<double>(), 1, 0.02) << comparison["depth_A"][i];
    ++judged;
  }
  EXPECT_GE(judged, 8);
  EXPECT_NE(outcome.out.find("the atoms break at"), std::string::npos) << outcome.out;
}

/// Bonds that grow into the switch do not break, and a law that ends is no sheet that tears.
TEST(Breaking, AnArtefactAndACalibrationEndAreNoBreak) {
  const WorkFolder folder;
  const Outcome outcome = run_validate({"indentation", "--potential", "tersoff", "--radius", "20", "--loads", "disc",
                                        "--depth-max", "11", "--depth-step", "1", "--out", "run"},
                                       folder.path());
  const json summary = document(folder.path() / "run" / "summary.json");
  expect_valid(summary);
  EXPECT_EQ(run_of(summary, "atomistic", "disc")["ended"], "artefact");
  const json& sheet = run_of(summary, "sheet", "disc", "calibrated");
  EXPECT_EQ(sheet["ended"], "calibration_end");
  EXPECT_GE(sheet["longest_bond_A"].back().get<double>(), 1.66);
  EXPECT_FALSE(summary["agreement"].contains("breaking"));
  EXPECT_EQ(outcome.out.find("the atoms break"), std::string::npos) << outcome.out;
}

}  // namespace
