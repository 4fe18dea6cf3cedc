#include "compare/documents/texts/table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "compare/base/terminal.hpp"
#include "compare/documents/texts/ladder.hpp"
#include "tests/compare/results/sample_result.hpp"

using namespace validate;

namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string line_with(const std::string& text, const std::string& start) {
  for (const std::string& line : lines_of(text)) {
    if (line.starts_with(start)) return line;
  }
  return "";
}

// One line of text, whatever the breaks.
std::string unbroken(const std::string& text) {
  std::istringstream words(text);
  std::string joined;
  for (std::string word; words >> word;) joined += word + " ";
  return joined;
}

TEST(Table, HasTheLadderOfEveryCurveBesideTheTruth) {
  Result result = sample::full();
  Fit& fit = *closed_form_fit(result.runs[1].fits);
  fit.Eh_eV_per_A2 = 20;
  fit.Eh_interval_eV_per_A2 = {19.9, 20.1};
  fit.pretension_eV_per_A2 = -0.01;
  fit.pretension_interval_eV_per_A2 = {-0.02, 0};
  fit.rms_relative = 0.0123;
  const std::string text = table(result);
  EXPECT_NE(text.find("atomistic disc (true: E·h 277.7 N/m, pretension 0.000 N/m)\n  Eq. 16"), std::string::npos);
  // 20 × 16.02176634 = 320.4, 19.9 × … = 318.8, 20.1 × … = 322.0, −0.01 × … = −0.160
  const std::string row = line_with(text.substr(text.find("atomistic disc (true")), "  Eq. 16");
  for (const char* part : {"320.4", "318.8 … 322.0", "-0.160", "-0.320 … 0.000", "1.23"})
    EXPECT_NE(row.find(part), std::string::npos) << part << "\nin " << row;
  EXPECT_NE(text.find("  membrane itself"), std::string::npos);
  EXPECT_EQ(text.find("corrected"), std::string::npos);
  EXPECT_NE(line_with(text, "membrane point paper"), "");
}

TEST(Table, SaysWhatThePretensionIsMadeOf) {
  const Result result = sample::full();
  const auto parts = pretension_parts(result, LoadKind::disc);
  ASSERT_TRUE(parts);
  EXPECT_NEAR(parts->form + parts->softening + parts->bending + parts->rest, parts->total, 1e-12);
  EXPECT_NEAR(parts->total, closed_form_fit(result.runs[1].fits)->pretension_eV_per_A2, 1e-12);
  EXPECT_NE(unbroken(table(result)).find("that Eq. 16 reads as pretension and nobody imposed"), std::string::npos);
  Result fewer = result;
  std::erase_if(fewer.runs, [](const validate::Run& run) { return run.model == Model::sheet; });
  EXPECT_FALSE(pretension_parts(fewer, LoadKind::disc));
}

TEST(Table, SaysWhatWasLeftOutAndHowAPathEnded) {
  Result result = sample::full();
  const std::string text = table(result);
  EXPECT_NE(line_with(text, "atomistic point  ").find("artefact"), std::string::npos);
  EXPECT_NE(unbroken(text).find("atomistic point: 1 point with a bond ≥ 1.70 Å (artefact zone, from 22 Å on)"),
            std::string::npos)
      << text;
  const std::string failed = table(sample::atoms_failed());
  EXPECT_NE(unbroken(failed).find("atomistic disc: no fit: 0 usable points of 0"), std::string::npos) << failed;
  EXPECT_NE(unbroken(failed).find("atomistic disc: path ended (failed): ERROR: Lost atoms"), std::string::npos);
  EXPECT_NE(failed.find("No verdict: there is no"), std::string::npos);
}

TEST(Table, SaysWhereTheAtomsBreakAndWhereTheSheetTears) {
  Result result = sample::full();
  validate::Run& atoms =
      *std::ranges::find_if(result.runs, [](const validate::Run& run) { return run.is_atomistic(); });
  EXPECT_EQ(table(result).find("load: the atoms break"), std::string::npos);
  atoms.atoms().breaking = Breaking{.force_eV_per_A = 80,
                                    .depth_A = 10.1,
                                    .bracket = {80, 80.6},
                                    .depth_bracket_A = {10.1, 10.2},
                                    .past_artefact = false,
                                    .sheet_force_eV_per_A = 76,
                                    .sheet_depth_A = 9.8};
  std::string text = unbroken(table(result));
  for (const char* part : {"the atoms break at 80.00 … 80.60 eV/Å, between 10.10 and 10.20 Å",
                           "sheet tears at 76.00 eV/Å and 9.80 Å (0.950 of the force)."})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\nin " << text;
  atoms.atoms().breaking->past_artefact = true;
  text = unbroken(table(result));
  EXPECT_NE(text.find("in the artefact zone: the force is the cut-off's"), std::string::npos) << text;
  EXPECT_EQ(text.find("sheet tears at"), std::string::npos);
}

/// Leaving a law is what its curves do; tearing within it is news.
TEST(Table, TellsASheetThatTearsFromALawThatEnds) {
  Result result = sample::full();
  validate::Run& sheet =
      *std::ranges::find_if(result.runs, [](const validate::Run& run) { return run.model == Model::sheet; });
  sheet.ended_reason = "as it ended";
  sheet.ended = Ended::calibration_end;
  EXPECT_NE(table(result).find("calibration_end\n"), std::string::npos);
  EXPECT_EQ(table(result).find("as it ended"), std::string::npos);
  sheet.ended = Ended::rupture;
  EXPECT_NE(unbroken(table(result)).find("path ended (rupture): as it ended"), std::string::npos);
}

TEST(Table, StatesTheVerdictWithItsNumbers) {
  Result result = sample::full();
  ASSERT_TRUE(result.agreement);
  result.agreement->ratios = {{11, 1.01}, {12, 0.96}, {13, 1.02}};
  result.agreement->max_relative_difference = 0.04;
  result.agreement->outcome = Outcome::agree;
  const std::string passed = table(result);
  EXPECT_NE(passed.find("AGREEMENT\n"), std::string::npos);
  for (const char* part : {"0.03 to 0.22", "disc load", "4.00 %", "12 Å", "0.9600", "1.00 %", "own law, with bending",
                           "disc load: what a plain membrane lacks"}) {
    EXPECT_NE(unbroken(passed).find(part), std::string::npos) << part << "\nin " << passed;
  }
  result.agreement->outcome = Outcome::disagree;
  EXPECT_TRUE(table(result).starts_with("DISAGREEMENT\n"));
}

TEST(Table, FitsIntoItsWidth) {
  Result result = sample::full();
  result.runs[0].ended = Ended::not_converged;
  for (int i = 0; i < 60; ++i) result.runs[0].ended_reason += " word" + std::to_string(i);
  for (const int width : {120, 80, 60})
    for (const std::string& line : lines_of(table(result, width))) EXPECT_LE(width_of(line), width) << line;
}

TEST(Table, IsPlainUnlessAskedAndNeverColouredInAFile) {
  const Result result = sample::full();
  EXPECT_EQ(table(result).find('\033'), std::string::npos);
  EXPECT_NE(table(result, widest_line, true).find("\033["), std::string::npos);
  testing::internal::CaptureStdout();
  print_table(result);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), table(result, 80));  // no terminal
}

}  // namespace
