#include "compare/input/potential_file.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "compare/base/sha256.hpp"
#include "tests/compare/support.hpp"

namespace {

using namespace validate;
using compare_tests::Environment;
using compare_tests::expect_refusal;
using compare_tests::TemporaryFolder;

constexpr const char* parameters = "# comment\n C   C  C 3.0 1.0\n";
constexpr const char* description = R"(
description = "a test"
pair_style = "tersoff"
pair_coeff = ["* * {file} C"]
file = "my.tersoff"
declares = "C C C"
interaction_range = "0.65 nm"
artefact_bond = 1.8
citation = "nobody"
)";

class PotentialFileTest : public testing::Test {
 protected:
  PotentialFile read(std::string_view name) {
    return read_potential(name, folder_.path() / "potentials", "--potential");
  }
  PotentialFile read_text(std::string_view content) { return read(folder_.write("x.toml", content).string()); }

  std::string without(std::string_view key) const {
    std::string text = description;
    const auto begin = text.find("\n" + std::string(key) + " =") + 1;
    return text.erase(begin, text.find('\n', begin) + 1 - begin);
  }

  TemporaryFolder folder_;
};

TEST_F(PotentialFileTest, ByName) {
  folder_.write("potentials/mine.toml", description);
  folder_.write("potentials/my.tersoff", parameters);
  const PotentialFile read_back = read("mine");
  EXPECT_EQ(read_back.potential.name, "mine");
  EXPECT_EQ(read_back.potential.pair_style, "tersoff");
  EXPECT_EQ(read_back.potential.pair_coeff, std::vector<std::string>{"* * {file} C"});
  EXPECT_EQ(read_back.potential.file, (folder_.path() / "potentials/my.tersoff").string());
  EXPECT_EQ(read_back.potential.mass, 12.011);
  EXPECT_DOUBLE_EQ(read_back.potential.interaction_range_A, 6.5);
  EXPECT_EQ(read_back.potential.artefact_bond_A, 1.8);
  EXPECT_EQ(read_back.potential.description, "a test");
  EXPECT_EQ(read_back.potential.citation, "nobody");
  EXPECT_EQ(read_back.sha256, sha256(parameters));
}

TEST_F(PotentialFileTest, ByPath) {
  folder_.write("my.tersoff", parameters);
  EXPECT_EQ(read_text(description).potential.name, "x");
}

TEST_F(PotentialFileTest, ParametersBesideTheDescriptionComeFirst) {
  folder_.write("elsewhere/my.tersoff", parameters);
  const Environment variable("LAMMPS_POTENTIALS", "/no/such:" + (folder_.path() / "elsewhere").string());
  EXPECT_EQ(read_text(description).potential.file, (folder_.path() / "elsewhere/my.tersoff").string());
  folder_.write("my.tersoff", parameters);
  EXPECT_EQ(read_text(description).potential.file, (folder_.path() / "my.tersoff").string());
}

TEST_F(PotentialFileTest, APathToParametersIsSeenFromTheDescription) {
  folder_.write("sub/other.tersoff", parameters);
  std::string text = description;
  text.replace(text.find("my.tersoff"), 10, "sub/other.tersoff");
  EXPECT_EQ(read_text(text).potential.file, (folder_.path() / "sub/other.tersoff").string());
}

TEST_F(PotentialFileTest, WithoutParameterFile) {
  const PotentialFile kim = read_text("pair_style = \"kim X\"\npair_coeff = [\"* * C\"]\ninteraction_range = 8\n");
  EXPECT_TRUE(kim.potential.file.empty());
  EXPECT_TRUE(kim.sha256.empty());
}

TEST_F(PotentialFileTest, OpenKimModelsAreLookedFor) {
  folder_.write("portable/Mine__MO_000000000000_000/libkim-api-portable-model.so", "library");
  folder_.write("simulator/Sim__SM_000000000000_000/libkim-api-simulator-model.so", "library");
  const Environment portable("KIM_API_PORTABLE_MODELS_DIR", (folder_.path() / "portable").string());
  const Environment simulator("KIM_API_SIMULATOR_MODELS_DIR", (folder_.path() / "simulator").string());
  const std::string start = "interaction_range = 8\n[kim]\nmodel = ";
  const PotentialFile pair = read_text(start + "\"Mine__MO_000000000000_000\"\n");
  EXPECT_EQ(pair.potential.pair_style, "kim Mine__MO_000000000000_000");
  EXPECT_EQ(pair.potential.pair_coeff, std::vector<std::string>{"* * C"});
  EXPECT_EQ(pair.sha256, sha256("library"));
  const PotentialFile whole = read_text(start + "\"Sim__SM_000000000000_000\"\n");
  EXPECT_EQ(whole.potential.kim_model, "Sim__SM_000000000000_000");
  EXPECT_TRUE(whole.potential.pair_style.empty());
  expect_refusal([&] { read_text(start + "\"Mine__MO_000000000000_001\"\n"); },
                 {"x.toml:3: model", "not installed", "mean 'Mine__MO_000000000000_000'?"});
  expect_refusal([&] { read_text("pair_style = \"rebo\"\n" + start + "\"Mine__MO_000000000000_000\"\n"); },
                 {"x.toml", "[kim] model takes the place of pair_style"});
  expect_refusal([&] { read_text("[kim]\nmodel = \"Mine__MO_000000000000_000\"\n"); },
                 {"'interaction_range' is missing"});
}

TEST_F(PotentialFileTest, NamesMayHaveAFolder) {
  folder_.write("potentials/kim/mine.toml", description);
  folder_.write("potentials/kim/my.tersoff", parameters);
  EXPECT_EQ(read("kim/mine").potential.name, "mine");
}

/// AIREBO's and REBO's files look alike; LAMMPS takes either and computes nonsense.
TEST_F(PotentialFileTest, RebosFileIsNotAirebos) {
  const auto text = [](const char* style) {
    return fmt::format(
        "pair_style = \"{}\"\npair_coeff = [\"* * {{file}} C\"]\nfile = \"my.CH\"\ninteraction_range = 5\n", style);
  };
  folder_.write("my.CH", "# AIREBO Brenner/Stuart potential\n1.7 rcmin_CC\n");
  expect_refusal([&] { read_text(text("rebo")); }, {"x.toml:3: file", "my.CH", "of AIREBO, not of 'rebo'"});
  EXPECT_NO_THROW(read_text(text("airebo 3.0 1 1")));
  folder_.write("my.CH", "# REBO2 Brenner potential modified from CH.airebo\n1.7 rcmin_CC\n");
  expect_refusal([&] { read_text(text("airebo 3.0 1 1")); }, {"my.CH", "of REBO, not of 'airebo'"});
  EXPECT_NO_THROW(read_text(text("rebo")));
}

TEST_F(PotentialFileTest, OtherParametersThanDescribedAreAWarning) {
  const std::string text = description + std::string("parameters_sha256 = \"") + sha256(" C C C 3.0 1.0 ") + "\"\n";
  folder_.write("my.tersoff", parameters);
  EXPECT_TRUE(read_text(text).warnings.empty()) << "comments and blanks do not count";
  folder_.write("my.tersoff", "C C C 3.0 1.1\n");
  const PotentialFile edited = read_text(text);
  ASSERT_EQ(edited.warnings.size(), 1u);
  EXPECT_NE(edited.warnings[0].find("my.tersoff"), std::string::npos);
}

TEST_F(PotentialFileTest, UnknownName) {
  folder_.write("potentials/rebo.toml", description);
  folder_.write("potentials/airebo.toml", description);
  folder_.write("potentials/notes.txt", "");
  EXPECT_EQ(available_potentials(folder_.path() / "potentials"), (std::vector<std::string>{"airebo", "rebo"}));
  expect_refusal([&] { read("aireb"); },
                 {"--potential", "'aireb'", "available: airebo, rebo", "TOML file", "did you mean 'airebo'?"});
  expect_refusal([&] { read("no/such.toml"); }, {"--potential", "there is no file", "no/such.toml"});
}

TEST_F(PotentialFileTest, MissingParameterFileNamesThePlaces) {
  const Environment variable("LAMMPS_POTENTIALS", "/first/place:/second/place");
  expect_refusal([&] { read_text(description); }, {"x.toml:5: file", "'my.tersoff'", folder_.path().string(),
                                                   "/first/place, /second/place, /", "potentials"});
}

TEST_F(PotentialFileTest, BadParameterFiles) {
  for (const char* content : {"", "\n\n", "# only\n  # comments\n"}) {
    folder_.write("my.tersoff", content);
    expect_refusal([&] { read_text(description); }, {"x.toml:5: file", "my.tersoff", "no parameters"});
  }
  folder_.write("my.tersoff", "# C C C\nSi Si Si 3.0\n");
  expect_refusal([&] { read_text(description); }, {"my.tersoff", "does not hold 'C C C'", "carbon"});
  std::filesystem::remove(folder_.path() / "my.tersoff");
  std::filesystem::create_directory(folder_.path() / "my.tersoff");
  expect_refusal([&] { read_text(description); }, {"my.tersoff", "is a folder"});
}

TEST_F(PotentialFileTest, UnreadableParameterFile) {
  std::string text = description;
  text.replace(text.find("my.tersoff"), 10, "/proc/self/mem");  // exists, and reading it fails even for root
  expect_refusal([&] { read_text(text); }, {"x.toml:5: file", "cannot read '/proc/self/mem'"}, ExitCode::file_failed);
}

TEST_F(PotentialFileTest, MissingKeys) {
  folder_.write("my.tersoff", parameters);
  for (const char* key : {"pair_style", "pair_coeff", "interaction_range", "file"}) {
    expect_refusal([&] { read_text(without(key)); }, {"x.toml", "'" + std::string(key) + "' is missing"});
  }
  for (const char* key : {"description", "citation", "declares", "artefact_bond"}) {
    EXPECT_NO_THROW(read_text(without(key))) << key;
  }
}

TEST_F(PotentialFileTest, BadKeys) {
  folder_.write("my.tersoff", parameters);
  const std::string text = description;
  expect_refusal([&] { read_text(text + "pair_styl = 3\n"); }, {"x.toml:10", "'pair_styl'", "mean 'pair_style'?"});
  expect_refusal([&] { read_text(text + "mass = -1\n"); }, {"x.toml:10: mass", "> 0"});
  expect_refusal([&] { read_text(text + "[table]\n"); }, {"x.toml:10", "unknown table [table]", "[kim]"});
  expect_refusal([&] { read_text(without("pair_coeff") + "pair_coeff = [\"* * C\"]\n"); },
                 {"x.toml", "{file}", "my.tersoff"});
  expect_refusal([&] { read_text("pair_style = "); }, {"x.toml:1:", "not valid TOML"});
}

TEST(Sha256, KnownDigests) {  // FIPS 180-2, appendix B, and the empty text
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST_F(PotentialFileTest, NothingThatOthersWriteRunsCode) {
  const std::string rest = "pair_coeff = [\"* * C\"]\ninteraction_range = 8\n";
  for (const char* style : {"python 8.0", "hybrid/overlay tersoff python 8.0", "mliap model mliappy x.pkl"}) {
    const std::string text = "pair_style = \"" + std::string(style) + "\"\n" + rest;
    expect_refusal([&] { read_text(text); }, {"x.toml:1: pair_style", "--allow-code"});
    EXPECT_NO_THROW(read_potential(folder_.write("x.toml", text).string(), folder_.path() / "potentials", "--potential",
                                   CodeInPotential::allowed));
  }
  for (const char* name : {"../x", "/home/x", "a b", "x.so", ""}) {
    expect_refusal([&] { read_text("interaction_range = 8\n[kim]\nmodel = \"" + std::string(name) + "\"\n"); },
                   {"x.toml"});
    if (const std::string one_word = name; !one_word.empty() && one_word.find(' ') == std::string::npos)
      expect_refusal([&] { read_text("pair_style = \"hybrid kim " + std::string(name) + "/\"\n" + rest); },
                     {"x.toml:1: pair_style", "OpenKIM"});
  }
}

}  // namespace
