#include "compare/cli/flags.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/compare/support.hpp"

namespace {

using namespace validate;
using compare_tests::expect_refusal;

struct Parsed {
  Case resolved;
  Origins origins;
  RunOptions options;
};

Parsed parse(std::vector<std::string> words, const Case& from_file = {}) {
  CLI::App command;
  const CaseFlags flags(command, Case());
  Parsed parsed{.resolved = from_file, .origins = {}, .options = {}};
  add_run_options(command, parsed.options);
  std::reverse(words.begin(), words.end());  // CLI11 takes a stack
  command.parse(words);
  flags.apply(parsed.resolved, parsed.origins);
  check(parsed.options);
  return parsed;
}

TEST(Flags, EveryFieldHasOneOfItsName) {
  CLI::App command;
  const CaseFlags flags(command, Case());
  const auto names = flag_names(command);
  const Case c;
  describe(c, [&](const Field& field, const auto&) {
    EXPECT_EQ(std::count(names.begin(), names.end(), "--" + std::string(field.name)), 1) << field.name;
  });
}

TEST(Flags, TakeUnitsListsAndSwitches) {
  const auto [c, origins, options] =
      parse({"--radius", "11 nm", "--tip-radius=8", "--loads", "disc, point", "--forces", "1, 1.602176634 nN,4", "--nu",
             "-0.158", "--E", "1.0209 TPa", "--pretension", "0.34 N/m", "--past-artefact", "--window", "0.1,0.2"});
  EXPECT_DOUBLE_EQ(c.radius_A, 110);
  EXPECT_EQ(c.tip_radius_A, 8);
  EXPECT_EQ(c.loads, (std::vector{LoadKind::disc, LoadKind::point}));
  ASSERT_EQ(c.forces_eV_per_A.size(), 3u);
  EXPECT_DOUBLE_EQ(c.forces_eV_per_A[1], 1);
  EXPECT_EQ(c.nu.value(), -0.158);
  EXPECT_DOUBLE_EQ(c.E_eV_per_A3.value(), 1020.9 / 160.2176634);
  EXPECT_DOUBLE_EQ(c.pretension_eV_per_A2, 0.34 / 16.02176634);
  EXPECT_TRUE(c.past_artefact);
  EXPECT_EQ(c.window, (std::vector<double>{0.1, 0.2}));
  EXPECT_EQ(origins.at("radius"), "--radius");
}

TEST(Flags, WinOverTheFileAndLeaveTheRest) {
  Case from_file;
  from_file.radius_A = 60;
  from_file.tip_radius_A = 7;
  from_file.past_artefact = true;
  const auto [c, origins, options] = parse({"--radius", "30", "--past-artefact=false"}, from_file);
  EXPECT_EQ(c.radius_A, 30);
  EXPECT_EQ(c.tip_radius_A, 7);
  EXPECT_FALSE(c.past_artefact);
  EXPECT_EQ(origins.size(), 2u);
}

TEST(Flags, ARepeatedListIsJoined) {
  EXPECT_EQ(parse({"--loads", "point", "--loads", "disc"}).resolved.loads.size(), 2u);
  expect_refusal([] { parse({"--radius", "3", "--radius", "4"}); }, {"--radius", "given 2 times"});
}

TEST(Flags, BadValuesNameTheFlag) {
  for (const char* value : {"0", "-5", "nan", "inf", "-5 nm"}) {
    expect_refusal([&] { parse({"--radius", value}); }, {"--radius:", "must be > 0 Å"});
  }
  expect_refusal([] { parse({"--radius", "ten"}); }, {"--radius: 'ten' is not a length"});
  expect_refusal([] { parse({"--radius", ""}); }, {"--radius: '' is not a length"});
  expect_refusal([] { parse({"--forces", ""}); }, {"--forces"});
  expect_refusal([] { parse({"--forces", "1,,2"}); }, {"--forces", "''"});
  expect_refusal([] { parse({"--loads", "point,dics"}); }, {"--loads", "'dics'", "point, disc", "mean 'disc'?"});
  expect_refusal([] { parse({"--loads", "point,"}); }, {"--loads", "empty"});
  expect_refusal([] { parse({"--models", "bth"}); }, {"--models", "membrane, atomistic, both", "mean 'both'?"});
  expect_refusal([] { parse({"--nu", "0.2 nm"}); }, {"--nu", "without a unit"});
  expect_refusal([] { parse({"--potential", ""}); }, {"--potential", "empty"});
}

TEST(Flags, OfARun) {
  const RunOptions options = parse({"--out", "runs/x", "--json", "-", "--ranks", "2", "--launcher", "srun -n 4",
                                    "--quiet", "--resume", "--dry-run", "--case", "my.toml"})
                                 .options;
  EXPECT_EQ(options.out, "runs/x");
  EXPECT_EQ(options.json, "-");
  EXPECT_EQ(options.ranks, 2);
  EXPECT_EQ(options.launcher, "srun -n 4");
  EXPECT_EQ(options.case_file, "my.toml");
  EXPECT_TRUE(options.quiet && options.resume && options.dry_run && !options.overwrite);

  const RunOptions defaults = parse({}).options;
  EXPECT_FALSE(defaults.out || defaults.json || defaults.case_file);
  EXPECT_EQ(defaults.ranks, 0);
  EXPECT_FALSE(defaults.quiet || defaults.resume || defaults.dry_run || defaults.overwrite);
}

TEST(Flags, OfARunThatAreBad) {
  expect_refusal([] { parse({"--resume", "--overwrite"}); }, {"--resume", "--overwrite", "exclude"});
  expect_refusal([] { parse({"--out", ""}); }, {"--out", "empty"});
  for (const char* ranks : {"-1", "abc", "5000", "1.5", "nan"}) {
    EXPECT_THROW(parse({"--ranks", ranks}), CLI::ParseError) << ranks;
  }
}

TEST(Flags, HelpGivesUnitRangeDefaultAndChoices) {
  CLI::App command;
  const CaseFlags flags(command, Case());
  const std::string help = command.help();
  for (const char* words : {"radius of the free sheet, half the side of a square; > 0 Å; default 110",
                            "default point,disc", "membrane, atomistic, both; default both", ">= -0.95 and <= 0.95",
                            "Case, table [membrane]", ">= 0 eV/Å²; default 0", "default 0.03,0.5"}) {
    EXPECT_NE(help.find(words), std::string::npos) << words;
  }
}

}  // namespace
