// The paper's figures: made, not empty, and their numbers where they belong.
#include <gtest/gtest.h>

#include <fstream>

#include "tests/cli/run_program.hpp"

namespace {

namespace fs = std::filesystem;
using cli_tests::Outcome;
using cli_tests::run_validate;
using cli_tests::WorkFolder;

std::string text(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void expect_complete(const fs::path& folder, const std::string& name, std::initializer_list<const char*> curves) {
  for (const char* ending : {".svg", ".png", ".csv", ".h5"})
    EXPECT_GT(text(folder / (name + ending)).size(), 5000u) << name << ending;
  const std::string csv = text(folder / (name + ".csv"));
  for (const char* curve : curves) EXPECT_NE(csv.find(curve), std::string::npos) << curve;
  EXPECT_EQ(csv.find("nan"), std::string::npos);
}

// Exit code 3 would say that a number with a tolerance (depths at 1500 nN against solvers written separately)
// is missed.
TEST(Figure, OneIsMade) {
  const WorkFolder folder;
  const Outcome outcome = run_validate({"figure", "1", "--out", "f", "--quiet"}, folder.path());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  expect_complete(folder.path() / "f", "figure1",
                  {"membrane, point", "disc of 16.5 nm", "sphere of 27.5 nm", "neo-Hookean", "softening law",
                   "342 ± 30", "a = 0.75"});
  EXPECT_FALSE(fs::exists(folder.path() / "f" / "work"));
  EXPECT_NE(outcome.out.find("depth at 1500 nN"), std::string::npos);
}

TEST(Figure, ThreeAndFourAreMade) {
  const WorkFolder folder;
  for (const char* number : {"3", "4"}) {
    const Outcome outcome = run_validate({"figure", number, "--out", "f", "--quiet"}, folder.path());
    EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  }
  expect_complete(folder.path() / "f", "figure3", {"point load", "disc of 10 Å", "larger_principal_stress_eV_per_A3"});
  EXPECT_LT(text(folder.path() / "f" / "figure4.svg").size(), 1.5e6);
  expect_complete(folder.path() / "f", "figure4", {"smaller_principal_stress_eV_per_A3", "tension rays", "state"});
}

TEST(Figure, UnknownOnesAreNamed) {
  const WorkFolder folder;
  const Outcome outcome = run_validate({"figure", "7"}, folder.path());
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("allowed: 1, 2, 3, 4"), std::string::npos) << outcome.err;
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

}  // namespace
