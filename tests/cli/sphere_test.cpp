// A rigid sphere instead of dead forces, on atoms and on the membrane.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "tests/cli/run_support.hpp"

namespace {

using namespace cli_tests;
using nlohmann::json;

TEST(Sphere, PressesBothSheetsAlikeAndCanBeJudged) {
  const WorkFolder folder;
  const Outcome outcome =
      run_validate(small_run({"--out", "run", "--loads", "sphere", "--judged-load", "sphere"}), folder.path());
  EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 3) << outcome.err;
  const json summary = document(folder.path() / "run" / "summary.json");
  expect_valid(summary);
  const json &atoms = run_of(summary, "atomistic", "sphere"), &card = run_of(summary, "membrane", "sphere", "card"),
             &paper = run_of(summary, "membrane", "sphere", "paper");
  for (const json* run : {&atoms, &card, &paper}) EXPECT_EQ((*run)["tip_A"], 5.0);
  EXPECT_EQ(card["a_A"], atoms["a_A"]);
  EXPECT_EQ(card["record_radius_A"], atoms["record_radius_A"]);
  EXPECT_EQ(summary["agreement"]["load"], "sphere");
  EXPECT_GE(summary["agreement"]["ratios"].size(), 2u);
  // The depth of record is the sheet's at one bond from the axis: above the sphere's lowest point there by b²/2R, and
  // by what the atom has sunk in.
  const double bond = atoms["record_radius_A"], rise = 5 - std::sqrt(25 - bond * bond);
  const double travel = atoms["conjugate_depth_A"].back(), depth = atoms["depth_A"].back();
  const double sunk = atoms["contact"]["deepest_penetration_A"];
  EXPECT_GT(travel - depth, rise - 0.05);
  EXPECT_LT(travel - depth, rise + sunk + 0.05);
  EXPECT_NEAR(card["conjugate_depth_A"].back().get<double>() - card["depth_A"].back().get<double>(), rise, 0.05);
}

TEST(Sphere, SaysWhatTheSoftnessOfItsContactDoes) {
  const WorkFolder folder;
  const Outcome outcome =
      run_validate(small_run({"--out", "run", "--loads", "sphere", "--models", "atomistic"}), folder.path());
  const json contact = run_of(document(folder.path() / "run" / "summary.json"), "atomistic", "sphere")["contact"];
  EXPECT_GT(contact["force_change_relative"].get<double>(), 0);  // a stiffer contact carries more at the same travel
  EXPECT_LT(contact["force_change_relative"].get<double>(), 0.1);
  EXPECT_LT(std::abs(contact["force_change_at_equal_depth_relative"].get<double>()),
            contact["force_change_relative"].get<double>());
  EXPECT_GT(contact["deepest_penetration_A"].get<double>(), 0.01);
  EXPECT_NE(outcome.out.find("inside the sphere"), std::string::npos);
  const Outcome again = run_validate({"report", "run"}, folder.path());
  EXPECT_EQ(again.exit_code, 0) << again.err;  // read back from run.h5
  std::ifstream page(folder.path() / "run" / "report.html");
  const std::string text{std::istreambuf_iterator<char>(page), {}};
  EXPECT_NE(text.find("inside the sphere"), std::string::npos);
}

}  // namespace
