// The paper's figure with atoms: minutes.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/cli/run_program.hpp"

TEST(FigureWithAtoms, TwoIsMade) {
  const cli_tests::WorkFolder folder;
  const auto outcome =
      cli_tests::run_validate({"figure", "2", "--potential", "tersoff", "--out", "f", "--quiet"}, folder.path());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  for (const char* ending : {"svg", "png", "csv", "h5"})
    EXPECT_GT(std::filesystem::file_size(folder.path() / "f" / (std::string("figure2.") + ending)), 5000u) << ending;
}

/// One search: up through smaller pressures, folded at the last, an equilibrium.
TEST(FigureWithAtoms, FourShowsTheSquareAsAtoms) {
  const cli_tests::WorkFolder folder;
  const auto outcome =
      cli_tests::run_validate({"figure", "4", "--atoms", "--starts", "1", "--out", "f", "--quiet"}, folder.path());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  for (const char* words : {"tersoff atoms: centre depth", "through smaller pressures", "wrinkled or taut in both",
                            "waves along the sides"})
    EXPECT_NE(outcome.out.find(words), std::string::npos) << words << outcome.out;
  const auto forces = outcome.out.find("max|f| ");
  ASSERT_NE(forces, std::string::npos) << outcome.out;
  EXPECT_LE(std::stod(outcome.out.substr(forces + 7)), 1e-4);
  EXPECT_LT(std::filesystem::file_size(folder.path() / "f" / "figure4.svg"), 1500000u);
}
