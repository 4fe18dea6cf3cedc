// Every kind of bad input: exit code, one message that names what is wrong and what is allowed, nothing left
// behind.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tests/cli/run_program.hpp"

namespace {

using cli_tests::Outcome;
using cli_tests::run_validate;
using cli_tests::WorkFolder;
using Words = std::vector<std::string>;

void expect_refused(const Outcome& outcome, int exit_code, const Words& words) {
  EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(outcome.err.starts_with("validate: error: ")) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << "one line: " << outcome.err;
  for (const std::string& word : words) {
    EXPECT_NE(outcome.err.find(word), std::string::npos) << "'" << word << "' is not in: " << outcome.err;
  }
}

struct BadCommandLine {
  Words command_line;
  Words message;
};

const BadCommandLine bad_command_lines[] = {
    {{"indentaton"}, {"unknown command 'indentaton'", "indentation", "did you mean 'indentation'?"}},
    {{"xyzzy"},
     {"unknown command 'xyzzy'",
      "allowed: bulge, curve, design, export, figure, fit, indentation, model, potential, published, report"}},
    {{"--radius", "30"}, {"'--radius'", "before the command", "indentation"}},
    {{"indentation", "--radus", "30"}, {"unknown flag '--radus'", "did you mean '--radius'?"}},
    {{"indentation", "--radus=30"}, {"unknown flag '--radus'", "did you mean '--radius'?"}},
    {{"indentation", "30"}, {"unexpected argument '30'", "--flag"}},
    {{"indentation", "--radius"}, {"--radius", "required"}},
    {{"indentation", "--radius", "3", "--radius", "4"}, {"--radius", "given 2 times"}},
    {{"indentation", "--radius", "7"}, {"--radius: 7 Å", "three lattice constants, 7.38 Å"}},
    {{"indentation", "--radius", "0"}, {"--radius: 0 Å", "must be > 0 Å"}},
    {{"indentation", "--radius", "-30"}, {"--radius: -30 Å", "must be > 0 Å"}},
    {{"indentation", "--radius", "nan"}, {"--radius: nan", "must be > 0 Å"}},
    {{"indentation", "--radius", "inf"}, {"--radius: inf", "must be > 0 Å"}},
    {{"indentation", "--radius", "1 km"}, {"--radius", "unknown unit 'km'", "A, pm, nm, um, mm, m", "mean"}},
    {{"indentation", "--radius", "1 mm"}, {"--radius", "3000 Å"}},
    {{"indentation", "--tip-radius", "110"}, {"--tip-radius", "wider than the sheet", "110 Å"}},
    {{"indentation", "--tip-radius", "109"}, {"--tip-radius", "wider than the sheet", "104.5 Å"}},
    {{"indentation", "--forces", "1,1e5"}, {"--forces: 100000 eV/Å", "tear", "at most"}},
    {{"indentation", "--law", "leee"}, {"--law", "'leee'", "neo-hookean", "did you mean 'lee'?"}},
    {{"indentation", "--law", "mooney-rivlin"}, {"--law", "needs second-share"}},
    {{"indentation", "--third-order", "-690 N/m"}, {"--third-order", "'svk'", "no such parameter"}},
    {{"indentation", "--law", "lee", "--third-order", "-690 N"}, {"--third-order", "unknown unit 'N'", "N/m"}},
    {{"bulge", "--law", "lee", "--second-share", "1"}, {"--second-share", "'lee'", "third-order in eV/Å²"}},
    {{"indentation", "--law", "lee", "--models", "atomistic"}, {"--law", "'lee'", "--models"}},
    {{"indentation", "--depth-max", "111"}, {"--depth-max: 111 Å", "deeper than the radius, 110 Å"}},
    {{"indentation", "--depth-max", "1", "--depth-step", "2"}, {"--depth-step", "2 Å", "largest depth, 1 Å"}},
    {{"indentation", "--depth-step", "1e-6"}, {"--depth-step", "levels", "at most 10000"}},
    {{"indentation", "--forces", "1,-2"}, {"--forces: -2 eV/Å", "> 0 eV/Å"}},
    {{"indentation", "--forces", "5,5,5"}, {"--forces: 5 eV/Å", "twice"}},
    {{"bulge", "--pressures", "1e-3,2e-3,1e-3"}, {"--pressures: 0.001 eV/Å³", "twice"}},
    {{"indentation", "--pretension", "0.34 N"}, {"--pretension", "unknown unit 'N'", "N/m"}},
    {{"indentation", "--loads", "point,dics"}, {"--loads", "'dics'", "point, disc", "did you mean 'disc'?"}},
    {{"indentation", "--models", "atoms"}, {"--models", "'atoms'", "membrane, atomistic, both"}},
    {{"indentation", "--window", "0.2,0.1"}, {"--window", "two increasing numbers"}},
    {{"indentation", "--potential", "aireb"}, {"--potential", "'aireb'", "lcbop, rebo", "did you mean 'airebo'?"}},
    {{"indentation", "--potential", "no/such.toml"}, {"--potential", "there is no file", "no/such.toml"}},
    {{"indentation", "--models", "membrane", "--E", "5", "--nu", "0.2"}, {"--E, --nu", "missing: thickness"}},
    {{"indentation", "--E", "5", "--nu", "0.2", "--thickness", "1"}, {"--E, --thickness, --nu", "--models membrane"}},
    {{"indentation", "--nu", "1"}, {"--nu: 1 ", ">= -0.95 and <= 0.95"}},
    {{"indentation", "--nu", "-0.99"}, {"--nu: -0.99 ", ">= -0.95 and <= 0.95"}},
    {{"indentation", "--depth-step", "0.01"}, {"--depth-step", "110 Å", "resolve 0.01 Å", "at least 0.024 Å"}},
    {{"indentation", "--depth-max", "0.001"}, {"--depth-max", "resolve 0.001 Å"}},
    {{"indentation", "--forces", "1e-6"}, {"--forces: 1e-06 eV/Å", "at least 0.0001 eV/Å"}},
    {{"indentation", "--vacancies", "1,2,3"}, {"--vacancies", "3 numbers", "pairs"}},
    {{"indentation", "--stone-wales", "90,90"}, {"--stone-wales", "90, 90 Å", "outside", "110 Å"}},
    {{"indentation", "--centre", "atm"}, {"--centre", "'atm'", "hexagon, atom", "did you mean 'atom'?"}},
    {{"indentation", "--rotation-deg", "nan"}, {"--rotation-deg: nan", ">= -360 and <= 360"}},
    {{"indentation", "--switch-length", "2.5"}, {"--switch-length: 2.5 Å", "<= 1.99 Å"}},
    {{"indentation", "--switch-length", "1.92", "--potential", "tersoff"},
     {"--switch-length", "'tersoff'", "no switch"}},
    {{"indentation", "--ranks", "-1"}, {"--ranks", "-1", "0 to 4096"}},
    {{"indentation", "--resume", "--overwrite"}, {"--resume", "--overwrite"}},
    {{"indentation", "--case", "nope.toml"}, {"--case", "there is no file 'nope.toml'"}},
};

/// A membrane of given constants, in which only the first wrong value differs from a good one.
Words given(const Words& wrong) {
  Words words = {"indentation", "--models", "membrane", "--loads", "disc"};
  words.insert(words.end(), wrong.begin(), wrong.end());
  for (const auto& [flag, value] : {std::pair("--E", "5"), {"--thickness", "1"}, {"--nu", "0.2"}, {"--radius", "100"}})
    if (std::find(wrong.begin(), wrong.end(), flag) == wrong.end()) words.insert(words.end(), {flag, value});
  return words;
}

const BadCommandLine bad_membranes[] = {
    {given({"--E", "1e300"}), {"--E, --thickness", "1e+300", "1e+12"}},
    {given({"--E", "1e300", "--thickness", "1e300"}), {"--E, --thickness", "inf"}},
    {given({"--E", "1e-300"}), {"--E, --thickness", "1e-300"}},
    {given({"--radius", "1e30"}), {"--radius", "1e+30 Å", "to 1e+14 Å"}},
    {given({"--radius", "1e-30"}), {"--radius", "1e-30 Å", "0.001 Å to"}},
    {given({"--pretension", "1e6"}), {"--pretension", "1000000 eV/Å²", "5 eV/Å²"}},
    {given({"--forces", "10,1e300"}), {"--forces", "1e+300 eV/Å", "500 eV/Å"}},
    {given({"--tip-radius", "1e-12"}), {"--tip-radius", "1e-12 Å", "too small"}},
    {given({"--tip-radius", "99.999"}), {"--tip-radius", "wider than the sheet", "95 Å"}},
};

void expect_all_refused(std::span<const BadCommandLine> all) {
  const WorkFolder folder;
  for (const auto& [command_line, message] : all) {
    SCOPED_TRACE(testing::PrintToString(command_line));
    expect_refused(run_validate(command_line, folder.path()), 2, message);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  }
}

TEST(BadInput, MembranesBeyondReason) { expect_all_refused(bad_membranes); }
TEST(BadInput, CommandLines) { expect_all_refused(bad_command_lines); }

/// What only the start of a run finds out: the same, and no run folder remains.
TEST(BadInput, FoundBeforeAnythingIsComputed) {
  const struct {
    Words more;
    int exit_code;
    Words message;
  } bad_runs[] = {
      {{"--json", "no/such/folder/x.json"}, 6, {"cannot write", "no/such/folder/x.json"}},
      {{"--json", "."}, 6, {"--json", "'.'", "folder"}},
      {{"--json", ".", "--out", "deep/er/run/"}, 6, {"--json"}},
      {{"--launcher", "no-such-launcher -n 2"}, 5, {"--launcher", "'no-such-launcher'", "PATH"}},
  };
  const WorkFolder folder;
  for (const auto& [more, exit_code, message] : bad_runs) {
    SCOPED_TRACE(testing::PrintToString(more));
    Words words = {"indentation", "--radius", "15", "--tip-radius", "5", "--quiet"};
    words.insert(words.end(), more.begin(), more.end());
    expect_refused(run_validate(words, folder.path()), exit_code, message);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  }
}

TEST(BadInput, NothingAskedFor) {
  const WorkFolder folder;
  const Outcome outcome = run_validate({}, folder.path());
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_NE(outcome.err.find("validate indentation --radius 110"), std::string::npos) << outcome.err;
}

TEST(BadInput, CaseFiles) {
  const struct {
    std::string content;
    Words message;
  } bad_files[] = {
      {"radius = 30\nradus = 3\n", {"bad.toml:2", "unknown key 'radus'", "did you mean 'radius'?"}},
      {"radius = 30\n[membrain]\n", {"bad.toml:2", "[membrain]", "did you mean 'membrane'?"}},
      {"radius = \"11 nmm\"\n", {"bad.toml:1: radius", "'nmm'", "did you mean 'nm'?"}},
      {"\nradius = nan\n", {"bad.toml:2: radius", "> 0 Å"}},
      {"radius = true\n", {"bad.toml:1: radius", "expected a number"}},
      {"loads = [\"point\"\nradius = 3\n", {"bad.toml:2:", "not valid TOML"}},
      {"radius = 30 # \xff\n", {"bad.toml:1:", "not valid TOML"}},
      {"tip-radius = 200\n", {"bad.toml:1: tip-radius", "wider than the sheet"}},
      {"potential = \"none.toml\"\n", {"bad.toml:1: potential", "there is no file", "none.toml"}},
  };
  const WorkFolder folder;
  for (const auto& [content, message] : bad_files) {
    SCOPED_TRACE(content);
    folder.write("bad.toml", content);
    expect_refused(run_validate({"indentation", "--case", "bad.toml"}, folder.path()), 2, message);
    std::filesystem::remove(folder.path() / "bad.toml");
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  }
}

TEST(BadInput, AFileThatCannotBeReadIsExitCodeSix) {
  const WorkFolder folder;
  expect_refused(run_validate({"indentation", "--case", "/proc/self/mem"}, folder.path()), 6,
                 {"--case", "cannot read '/proc/self/mem'"});
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(BadInput, Potentials) {
  const WorkFolder folder, work;
  folder.write("empty.tersoff", "# nothing\n");
  const std::string start = "pair_style = \"tersoff\"\npair_coeff = [\"* * {file} C\"]\ninteraction_range = 7\n";
  const struct {
    std::string content;
    Words message;
  } bad_potentials[] = {
      {start + "file = \"absent.tersoff\"\n", {"bad.toml:4: file", "'absent.tersoff'", "/elsewhere", "potentials"}},
      {start + "file = \"empty.tersoff\"\n", {"bad.toml:4: file", "empty.tersoff", "no parameters"}},
      {start + "fil = \"absent.tersoff\"\n", {"bad.toml:4", "unknown key 'fil'", "did you mean 'file'?"}},
      {start, {"bad.toml", "'file' is missing"}},
  };
  const std::string path = (folder.path() / "bad.toml").string();
  for (const auto& [content, message] : bad_potentials) {
    SCOPED_TRACE(content);
    folder.write("bad.toml", content);
    expect_refused(run_validate({"indentation", "--potential", path}, work.path(), {"LAMMPS_POTENTIALS=/elsewhere"}), 2,
                   message);
    EXPECT_TRUE(std::filesystem::is_empty(work.path()));
  }
}

TEST(BadInput, InputsVariable) {
  const WorkFolder folder;
  expect_refused(run_validate({"indentation"}, folder.path(), {"VALIDATE_INPUTS=/no/such"}), 2,
                 {"VALIDATE_INPUTS", "'/no/such'"});
}

}  // namespace
