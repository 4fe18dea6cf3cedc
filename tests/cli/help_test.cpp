#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/cli/run_program.hpp"

namespace {

using cli_tests::Outcome;
using cli_tests::run_validate;
using cli_tests::WorkFolder;

TEST(Help, ListsCommandsWithAnExample) {
  const WorkFolder folder;
  const Outcome help = run_validate({"--help"}, folder.path());
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_EQ(help.err, "");
  EXPECT_NE(help.out.find("indentation "), std::string::npos) << help.out;
  EXPECT_NE(help.out.find("validate indentation --radius 110"), std::string::npos) << help.out;
}

TEST(Help, OfACommandHasGroupsUnitsRangesDefaultsAndAnExample) {
  const WorkFolder folder;
  const Outcome help = run_validate({"indentation", "--help"}, folder.path());
  EXPECT_EQ(help.exit_code, 0);
  for (const char* words : {"--radius", "> 0 Å; default 110", "[membrane]", "[agreement]", "--dry-run",
                            "Run:", "validate indentation --radius 110", "eV/Å²"}) {
    EXPECT_NE(help.out.find(words), std::string::npos) << words << " is not in\n" << help.out;
  }
}

TEST(Help, IsAlsoACommand) {
  const WorkFolder folder;
  EXPECT_EQ(run_validate({"help", "fit"}, folder.path()).out, run_validate({"fit", "--help"}, folder.path()).out);
  EXPECT_EQ(run_validate({"help"}, folder.path()).out, run_validate({"--help"}, folder.path()).out);
  const Outcome unknown = run_validate({"help", "fitt"}, folder.path());
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_NE(unknown.err.find("did you mean 'fit'"), std::string::npos) << unknown.err;
}

TEST(Help, TakesLessThanFiftyMilliseconds) {
  const WorkFolder folder;
  double best_ms = 1e9;
  for (int i = 0; i < 10; ++i)
    best_ms = std::min(best_ms, run_validate({"indentation", "--help"}, folder.path()).cpu_ms);
  EXPECT_LT(best_ms, 50);
}

TEST(Version, IsPrintedOnStdout) {
  const WorkFolder folder;
  const Outcome version = run_validate({"--version"}, folder.path());
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_NE(version.out.find("validate"), std::string::npos) << version.out;
  EXPECT_NE(version.out.find('.'), std::string::npos) << version.out;
  EXPECT_EQ(version.err, "");
}

TEST(Help, LeavesNothingBehind) {
  const WorkFolder folder;
  run_validate({"--help"}, folder.path());
  run_validate({"--version"}, folder.path());
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
