#include "compare/input/case_file.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "tests/compare/support.hpp"

namespace {

using namespace validate;
using compare_tests::expect_refusal;
using compare_tests::TemporaryFolder;

class CaseFile : public testing::Test {
 protected:
  Case read(std::string_view content) {
    Case c;
    origins_ = read_case(folder_.write("case.toml", content), c);
    return c;
  }
  void refuses(std::string_view content, std::vector<std::string> words) {
    words.push_back((folder_.path() / "case.toml").string());
    expect_refusal([&] { read(content); }, words);
  }

  TemporaryFolder folder_;
  Origins origins_;
};

TEST_F(CaseFile, ReadsEveryKey) {
  const Case c = read(R"(
shape = "square"
radius = "6 nm"
size = "12 nm"
edge = "sliding"
potential = "rebo"
loads = ["disc"]
tip-radius = 12
depth-max = "1 nm"
depth-step = 0.5
forces = [1, "1.602176634 nN", 2.5]
pressures = ["160.2176634 GPa", 0.5]
pretension = "16.02176634 mN/m"
models = "membrane"
units = "laboratory"
rim = "sliding"
rim-tension = "16.02176634 mN/m"
relaxed = true
temperature = "300 K"
statistics = "quantum"
modes = 4
sample = "20 ps"
error = "1 %"
seed = 7
[membrane]
E = "160.2176634 GPa"
thickness = "0.335 nm"
nu = -0.158
law = "lee"
third-order = "-16.02176634 N/m"
second-share = 0.25
extent = "full"
cells = 40
unrelaxed = true
[atomistic]
force-tolerance = 1e-6
past-artefact = true
unloading = true
switch-length = 1.92
centre = "atom"
rotation-deg = 12.5
vacancies = [3, "0.4 nm"]
stone-wales = [-5, 6]
preconditioner = "multigrid"
[agreement]
judged-load = "point"
window = [0.12, 0.14]
tolerance = 0.1
against = "membrane"
window-bond = "0.16 nm"
regime-tolerance = 0.05
)");
  EXPECT_EQ(c.shape, Shape::square);
  EXPECT_DOUBLE_EQ(c.radius_A, 60);
  EXPECT_DOUBLE_EQ(c.size_A.value(), 120);
  EXPECT_EQ(c.edge, Edge::sliding);
  EXPECT_EQ(c.potential, "rebo");
  EXPECT_EQ(c.loads, std::vector{LoadKind::disc});
  EXPECT_EQ(c.tip_radius_A, 12);
  EXPECT_DOUBLE_EQ(c.depth_max_A.value(), 10);
  EXPECT_EQ(c.depth_step_A, 0.5);
  ASSERT_EQ(c.forces_eV_per_A.size(), 3u);
  EXPECT_DOUBLE_EQ(c.forces_eV_per_A[1], 1);
  EXPECT_EQ(c.forces_eV_per_A[2], 2.5);
  ASSERT_EQ(c.pressures_eV_per_A3.size(), 2u);
  EXPECT_DOUBLE_EQ(c.pressures_eV_per_A3[0], 1);
  EXPECT_EQ(c.pressures_eV_per_A3[1], 0.5);
  EXPECT_DOUBLE_EQ(c.pretension_eV_per_A2, 0.001);
  EXPECT_EQ(c.models, Models::membrane);
  EXPECT_EQ(c.units, Units::laboratory);
  EXPECT_DOUBLE_EQ(c.E_eV_per_A3.value(), 1);
  EXPECT_DOUBLE_EQ(c.thickness_A.value(), 3.35);
  EXPECT_EQ(c.nu.value(), -0.158);
  EXPECT_EQ(c.law.name, "lee");
  EXPECT_EQ(c.law.parameters, (std::vector<std::optional<double>>{0.25, -1}));
  EXPECT_EQ(c.extent, Extent::full);
  EXPECT_EQ(c.cells.value(), 40);
  EXPECT_TRUE(c.unrelaxed);
  EXPECT_EQ(c.force_tolerance_eV_per_A, 1e-6);
  EXPECT_TRUE(c.past_artefact);
  EXPECT_TRUE(c.unloading);
  EXPECT_EQ(c.switch_length_A.value(), 1.92);
  EXPECT_EQ(c.centre, Centre::atom);
  EXPECT_EQ(c.rotation_deg, 12.5);
  EXPECT_EQ(c.vacancies_A, (std::vector<double>{3, 4}));
  EXPECT_EQ(c.stone_wales_A, (std::vector<double>{-5, 6}));
  EXPECT_EQ(c.preconditioner, Preconditioner::multigrid);
  EXPECT_EQ(c.judged_load, LoadKind::point);
  EXPECT_EQ(c.window, (std::vector<double>{0.12, 0.14}));
  EXPECT_EQ(c.tolerance, 0.1);
  EXPECT_EQ(c.against, Against::membrane);
  EXPECT_DOUBLE_EQ(c.window_bond_A, 1.6);
  EXPECT_EQ(c.regime_tolerance, 0.05);
  // Every field is covered above: each has an origin with its line.
  int fields = 0;
  describe(c, [&](const Field& field, const auto&) {
    ++fields;
    EXPECT_TRUE(origins_.contains(field.name)) << field.name;
  });
  EXPECT_EQ(static_cast<int>(origins_.size()), fields);
  EXPECT_EQ(origins_.at("radius"), (folder_.path() / "case.toml").string() + ":3: radius");
  EXPECT_EQ(origins_.at("nu"), (folder_.path() / "case.toml").string() + ":28: nu");
}

TEST_F(CaseFile, KeepsWhatItDoesNotGive) {
  const Case c = read("radius = 30\n");
  EXPECT_EQ(c.radius_A, 30);
  EXPECT_EQ(c.potential, "airebo");
  EXPECT_FALSE(c.depth_max_A);
  EXPECT_EQ(origins_.size(), 1u);
}

TEST_F(CaseFile, APotentialsPathStandsBesideTheCase) {
  EXPECT_EQ(read("potential = \"mine/c.toml\"").potential, (folder_.path() / "mine/c.toml").string());
  EXPECT_EQ(read("potential = \"/opt/c.toml\"").potential, "/opt/c.toml");
  EXPECT_EQ(read("potential = \"rebo\"").potential, "rebo");
}

TEST_F(CaseFile, UnknownNames) {
  refuses("radius = 30\nradus = 3\n", {"case.toml:2", "unknown key 'radus'", "tip-radius", "did you mean 'radius'?"});
  refuses("[membrane]\nnuu = 0.2\n", {":2", "'nuu' in [membrane]", "E, thickness, nu", "did you mean 'nu'?"});
  refuses("\n[atomistics]\n", {":2", "unknown table [atomistics]", "[agreement]", "did you mean 'atomistic'?"});
  refuses("[expected]\nforce = 1\n", {":1", "unknown table [expected]"});
  refuses("past-artefact = true\n", {":1", "'past-artefact' belongs to [atomistic], not to the top level"});
  EXPECT_EQ(read("nu = 0.2\n").nu.value(), 0.2);  // the membrane's may stand there, too
  refuses("[agreement]\nradius = 3\n", {":2", "'radius' belongs to the top level, not to [agreement]"});
  refuses("membrane = 3\n", {":1", "membrane", "expected a table", "found an integer"});
  refuses("[[membrane]]\nnu = 0.2\n", {":1", "membrane", "expected a table", "found a list"});
}

TEST_F(CaseFile, WrongTypes) {
  refuses("radius = true", {":1: radius", "expected a number in Å or a text with a unit", "found true or false"});
  refuses("radius = [1, 2]", {":1: radius", "found a list"});
  refuses("radius = 2020-01-01", {":1: radius", "found a date or time"});
  refuses("[radius]\nx = 1", {":1", "radius"});
  refuses("potential = 3", {":1: potential", "expected a text in quotes", "found an integer"});
  refuses("loads = \"disc\"", {":1: loads", "expected a list in [ ]", "found a text"});
  refuses("loads = [1]", {":1: loads", "expected a text in quotes"});
  refuses("forces = 3.5", {":1: forces", "expected a list in [ ]", "found a number"});
  refuses("forces = []", {":1: forces", "the list is empty"});
  refuses("forces = [1, true]", {":1: forces", "expected a number"});
  refuses("[membrane]\nnu = \"0.2\"", {":2: nu", "expected a number", "found a text"});
  refuses("[atomistic]\npast-artefact = 1", {":2: past-artefact", "expected true or false", "found an integer"});
}

TEST_F(CaseFile, ValuesOutOfRange) {
  for (const char* value : {"0", "-1", "nan", "inf", "-inf", "0.0", "\"-3 nm\"", "\"nan\"", "\"inf\""}) {
    refuses("\nradius = " + std::string(value), {":2: radius", "must be > 0 Å"});
  }
  refuses("pretension = -1e-9", {":1: pretension", "-1e-09", ">= 0 eV/Å²"});
  refuses("forces = [1, 0]", {":1: forces", "must be > 0 eV/Å"});
  refuses("[membrane]\nnu = 1", {":2: nu", ">= -0.95 and <= 0.95"});
  refuses("[agreement]\nwindow = [0.1, 1.5]", {":2: window", "1.5", "> 0 and < 1"});
  refuses("[atomistic]\nforce-tolerance = 1", {":2: force-tolerance", "<= 0.01 eV/Å"});
  refuses("radius = \"11 nmm\"", {":1: radius", "unknown unit 'nmm'", "did you mean 'nm'?"});
}

TEST_F(CaseFile, UnknownWords) {
  refuses("loads = [\"point\", \"dics\"]",
          {":1: loads", "'dics'", "allowed: point, disc, sphere, pressure", "did you mean 'disc'?"});
  refuses("models = \"atoms\"", {":1: models", "'atoms'", "membrane, atomistic, both"});
  refuses("[agreement]\njudged-load = \"poimt\"", {":2: judged-load", "did you mean 'point'?"});
  refuses("potential = \"\"", {":1: potential", "empty"});
}

TEST_F(CaseFile, WhatIsNotToml) {
  refuses("radius = 30\nloads = [\"point\"\nmodels = \"both\"\n", {"case.toml:3:", "not valid TOML"});
  refuses("radius = 30\nradius = 40\n", {":2:", "not valid TOML"});
  refuses("radius = 11 nm\n", {":1:", "not valid TOML"});
  refuses("radius 30\n", {":1:", "not valid TOML"});
  refuses("potential = \"airebo\n", {":1:", "not valid TOML"});
  refuses("radius = 30 # \xff\xfe\n", {":1:", "not valid TOML"});
  refuses(std::string_view("radius = 3\0", 11), {":1:", "not valid TOML"});
}

// toml++ 3.3 aborts on some malformed bytes unless its asserts are off; whatever the bytes, an Error must
// come out.
TEST_F(CaseFile, MalformedBytesNeverAbort) {
  const std::string good =
      "radius = \"6 nm\"\nloads = [\"disc\"]\n[membrane]\nnu = 0.165\n# µ\n[agreement]\nwindow=[.1]";
  std::mt19937 random(2010);
  int refused = 0;
  for (int i = 0; i < 1000; ++i) {
    std::string bad = good.substr(0, 1 + random() % good.size());
    for (int changes = 1 + static_cast<int>(random() % 4); changes > 0; --changes) {
      bad[random() % bad.size()] = static_cast<char>(random() % 256);
    }
    try {
      read(bad);
    } catch (const Error&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 600);
}

TEST_F(CaseFile, FilesThatCannotBeRead) {
  Case c;
  const auto missing = folder_.path() / "nope.toml";
  expect_refusal([&] { read_case(missing, c, "--case"); }, {"--case", "there is no file", missing.string()});
  expect_refusal([&] { read_case(folder_.path(), c); }, {folder_.path().string(), "is a folder"});
  // exists, and reading it fails for everyone, root included
  expect_refusal([&] { read_case("/proc/self/mem", c); }, {"cannot read '/proc/self/mem'"}, ExitCode::file_failed);
}

}  // namespace
