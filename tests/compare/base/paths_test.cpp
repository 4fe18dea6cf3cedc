#include "compare/base/paths.hpp"

#include <gtest/gtest.h>

#include "tests/compare/support.hpp"

namespace {

using namespace validate;
using compare_tests::Environment;
using compare_tests::expect_refusal;
using compare_tests::TemporaryFolder;
namespace fs = std::filesystem;

TEST(Paths, InputsOfABuildTree) {
  const TemporaryFolder tree;
  fs::create_directories(tree.path() / "inputs/potentials");
  EXPECT_EQ(find_inputs(tree.path() / "build", ""), tree.path() / "inputs");
}

TEST(Paths, InputsOfAnInstalledProgram) {
  const TemporaryFolder tree;
  fs::create_directories(tree.path() / "share/validate/potentials");
  fs::create_directories(tree.path() / "inputs");  // some other folder of that name
  EXPECT_EQ(find_inputs(tree.path() / "bin", ""), tree.path() / "share/validate");
}

TEST(Paths, TheEnvironmentWins) {
  const TemporaryFolder tree;
  fs::create_directories(tree.path() / "inputs/potentials");
  fs::create_directories(tree.path() / "mine/potentials");
  EXPECT_EQ(find_inputs(tree.path() / "build", (tree.path() / "mine").string()), tree.path() / "mine");
  const Environment variable("VALIDATE_INPUTS", (tree.path() / "mine").string());
  EXPECT_EQ(inputs_folder(), tree.path() / "mine");
}

TEST(Paths, AWrongVariableIsRefusedEvenIfTheBuildTreeHasInputs) {
  const TemporaryFolder tree;
  fs::create_directories(tree.path() / "inputs/potentials");
  expect_refusal([&] { find_inputs(tree.path() / "build", "/no/such/folder"); },
                 {"VALIDATE_INPUTS", "'/no/such/folder'", "potentials/"});
}

TEST(Paths, NoInputsNamesBothPlaces) {
  const TemporaryFolder tree;
  expect_refusal([&] { find_inputs(tree.path() / "build", ""); },
                 {(tree.path() / "inputs").string(), (tree.path() / "share/validate").string(), "VALIDATE_INPUTS"});
}

TEST(Paths, ProgramFolderIsThatOfThisTest) { EXPECT_TRUE(fs::is_regular_file(program_folder() / "compare_tests")); }

}  // namespace
