// Each fault of membrane/fault.hpp makes `validate verify membrane` fail, and nothing fails without one.
#include <gtest/gtest.h>

#include <set>
#include <string>

#define VALIDATE_FAULTS  // the names of the faults
#include "membrane/base/fault.hpp"
#include "tests/cli/run_program.hpp"

namespace {

using cli_tests::Outcome;
using cli_tests::run_validate;
using cli_tests::WorkFolder;

struct Found {
  const char* fault;
  const char* group;  ///< the quickest that finds it
  const char* row;    ///< a quantity that must fail
};

const Found all_found[] = {
    {"no-contraction", "laws", "S1 relaxed / S1 unrelaxed"},
    {"no-prestress", "patch", "stretch"},
    {"double-turning", "laws", "order of S's remainder, relaxed"},
    {"wrinkled-as-taut", "patch", "S2/Eh"},
    {"half-shear", "patch", "S1/Eh"},
    {"no-stress-stiffness", "patch", "order of the gradient's remainder"},
    {"shape-gradient-sign", "patch", "largest force inside"},
    {"dead-pressure", "patch", "order of its remainder"},
    {"no-pressure-stiffness", "patch", "order of the gradient's remainder"},
    {"double-contact", "patch", "order of its remainder"},
    {"open-mirror", "figure4", "centre depth, A"},
    {"constant-thickness", "patch", "h sigma1/Eh"},
    {"uneven-load", "disc", "centre depth, A"},
};

std::vector<std::string> command(const char* group) { return {"verify", "membrane", "--quiet", "--group", group}; }

class Fault : public ::testing::TestWithParam<Found> {};

TEST_P(Fault, MakesVerifyFail) {
  const WorkFolder folder;
  auto words = command(GetParam().group);
  words.insert(words.end(), {"--break", GetParam().fault});
  const Outcome outcome = run_validate(words, folder.path());
  EXPECT_EQ(outcome.exit_code, 3) << outcome.out << outcome.err;
  bool named = false;
  for (std::size_t at = outcome.out.find("FAIL"); at != std::string::npos; at = outcome.out.find("FAIL", at + 1))
    named = named || outcome.out.substr(at, outcome.out.find('\n', at) - at).find(GetParam().row) != std::string::npos;
  EXPECT_TRUE(named) << outcome.out;
}

INSTANTIATE_TEST_SUITE_P(Verify, Fault, ::testing::ValuesIn(all_found), [](const auto& tested) {
  std::string name = tested.param.fault;
  std::erase(name, '-');
  return name;
});

TEST(Faults, AreAllTried) {
  std::set<std::string_view> known, tried;
  for (const auto& fault : membrane::named_faults) known.insert(fault.name);
  for (const Found& found : all_found) tried.insert(found.fault);
  EXPECT_EQ(known, tried);
}

TEST(Faults, WithoutOneTheSameProgramPasses) {
  const WorkFolder folder;
  for (const char* group : {"laws", "patch", "disc"})
    EXPECT_EQ(run_validate(command(group), folder.path()).exit_code, 0);
}

TEST(Faults, UnknownNamesAreRefusedWithTheNearest) {
  const WorkFolder folder;
  auto words = command("laws");
  words.insert(words.end(), {"--break", "half-sheer"});
  const Outcome outcome = run_validate(words, folder.path());
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("did you mean 'half-shear'?"), std::string::npos) << outcome.err;
}

}  // namespace
