#include "compare/documents/texts/table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

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

TEST(Table, HasOneRowPerRunWithTheFitAndTheCard) {
  Result result = sample::full();
  Fit& fit = *closed_form_fit(result.runs[1].fits);
  fit.Eh_eV_per_A2 = 20;
  fit.Eh_stderr_eV_per_A2 = 0.1;
  fit.pretension_eV_per_A2 = -0.01;
  fit.pretension_stderr_eV_per_A2 = 0.002;
  fit.rms_relative = 0.0123;
  const std::string row = line_with(table(result), "atomistic disc ");
  // 20 × 16.02176634 = 320.4, 0.1 × … = 1.6, 0.01 × … = 0.160, 0.002 × … = 0.032; card 17.33 → 277.7
  for (const char* part : {"320.4 ± 1.6", "20.00", "277.7", "-0.160 ± 0.032", "1.23", "depth_max"}) {
    EXPECT_NE(row.find(part), std::string::npos) << part << "\nin " << row;
  }
  EXPECT_NE(line_with(table(result), "membrane point paper"), "");
}

TEST(Table, SaysWhatWasLeftOutAndHowAPathEnded) {
  Result result = sample::full();
  const std::string text = table(result);
  EXPECT_NE(line_with(text, "atomistic point ").find("artefact"), std::string::npos);
  EXPECT_NE(unbroken(text).find("atomistic point: 1 point with a bond ≥ 1.70 Å (artefact zone, from 22 Å on)"),
            std::string::npos)
      << text;
  const std::string failed = table(sample::atoms_failed());
  EXPECT_NE(unbroken(failed).find("atomistic disc: no fit: 0 usable points of 0"), std::string::npos) << failed;
  EXPECT_NE(unbroken(failed).find("atomistic disc: path ended (failed): ERROR: Lost atoms"), std::string::npos);
  EXPECT_NE(failed.find("No verdict: there is no"), std::string::npos);
}

TEST(Table, StatesTheVerdictWithItsNumbers) {
  Result result = sample::full();
  ASSERT_TRUE(result.agreement);
  result.agreement->ratios = {{11, 1.01}, {12, 0.96}, {13, 1.02}};
  result.agreement->max_relative_difference = 0.04;
  result.agreement->outcome = Outcome::agree;
  const std::string passed = table(result);
  EXPECT_NE(passed.find("\nAGREEMENT\n"), std::string::npos);
  for (const char* part : {"0.03 to 0.22", "disc load", "4.00 %", "12 Å", "0.9600", "1.00 %", "own law, with bending",
                           "disc load: what a plain membrane lacks"}) {
    EXPECT_NE(unbroken(passed).find(part), std::string::npos) << part << "\nin " << passed;
  }
  result.agreement->outcome = Outcome::disagree;
  EXPECT_NE(table(result).find("\nDISAGREEMENT\n"), std::string::npos);
}

TEST(Table, FitsIn120Columns) {
  Result result = sample::full();
  result.runs[0].ended = Ended::not_converged;
  for (int i = 0; i < 60; ++i) result.runs[0].ended_reason += " word" + std::to_string(i);
  for (const std::string& line : lines_of(table(result))) {
    const auto columns = std::ranges::count_if(line, [](char c) { return (c & 0xC0) != 0x80; });
    EXPECT_LE(columns, 120) << line;
  }
}

TEST(Table, IsPlainUnlessAskedAndNeverColouredInAFile) {
  const Result result = sample::full();
  EXPECT_EQ(table(result).find('\033'), std::string::npos);
  EXPECT_NE(table(result, true).find("\033["), std::string::npos);
  testing::internal::CaptureStdout();
  print_table(result, stdout);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), table(result));
}

}  // namespace
