#include "compare/input/case.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "tests/compare/support.hpp"

namespace {

using namespace validate;
using compare_tests::expect_refusal;

Case changed(const std::function<void(Case&)>& change) {
  Case c;
  change(c);
  return c;
}

Case given_constants() {
  return changed([](Case& c) {
    c.models = Models::membrane;
    c.E_eV_per_A3 = 6.372;
    c.thickness_A = 3.35;
    c.nu = 0.165;
  });
}

TEST(DepthLevels, EndAtTheLargestDepth) {
  const auto levels = depth_levels(Case{});  // 0.22 × 110 = 24.2, steps of 2
  ASSERT_EQ(levels.size(), 13u);
  for (int i = 0; i < 12; ++i) EXPECT_DOUBLE_EQ(levels[i], 2.0 * (i + 1));
  EXPECT_DOUBLE_EQ(levels.back(), 24.2);
}

TEST(DepthLevels, AreTwoAngstromApartUnlessConstantsAreGiven) {
  Case c;
  EXPECT_EQ(depth_levels(c).size(), 13u);  // 2, 4, … 24, 24.2
  EXPECT_EQ(depth_levels(c)[1], 4);
  c.radius_A = 8;  // 0.22 of it is less than 2 Å
  EXPECT_EQ(depth_levels(c), (std::vector<double>{0.22 * 8}));
  c = given_constants();
  c.radius_A = 5000;  // the same number of levels for any size
  EXPECT_EQ(depth_levels(c).size(), 13u);
  EXPECT_NEAR(depth_levels(c)[0], 5000 / 55., 1e-9);
}

TEST(DepthLevels, HaveNoDuplicateAtAMultiple) {
  Case c;
  c.depth_max_A = 0.3;  // 3 × 0.1 is above 0.3 in floating point
  c.depth_step_A = 0.1;
  EXPECT_EQ(depth_levels(c).size(), 3u);
  EXPECT_EQ(depth_levels(c).back(), 0.3);
  c.depth_max_A = 6 * (1 + 1e-12);
  c.depth_step_A = 2;
  EXPECT_EQ(depth_levels(c), (std::vector<double>{2, 4, 6 * (1 + 1e-12)}));
  c.depth_max_A = 6.001;
  EXPECT_EQ(depth_levels(c), (std::vector<double>{2, 4, 6, 6.001}));
  c.depth_max_A = 2;
  EXPECT_EQ(depth_levels(c), (std::vector<double>{2}));
}

TEST(Units, AreThoseOfTheValuesGivenAndNanometresForDrums) {
  const auto settled = [](Case c, const std::vector<std::string>& given) {
    settle_units(c, given);
    return c.units;
  };
  EXPECT_EQ(settled(Case{}, {}), Units::atomic);
  EXPECT_EQ(settled(Case{}, {"60", "airebo"}), Units::atomic);
  EXPECT_EQ(settled(Case{}, {"disc", "6 nm"}), Units::laboratory);
  Case drum;
  drum.potential.clear();
  drum.models = Models::membrane;
  drum.E_eV_per_A3 = drum.thickness_A = 1, drum.nu = 0.2, drum.radius_A = 5000;
  EXPECT_EQ(settled(drum, {}), Units::laboratory);
  drum.units = Units::atomic;  // as the user says
  EXPECT_EQ(settled(drum, {"1 um"}), Units::atomic);
}

TEST(Check, AcceptsTheDefaultsSilently) { EXPECT_TRUE(check(Case{}).empty()); }

TEST(Check, SmallSheetsOfAtoms) {
  expect_refusal([] { check(changed([](Case& c) { c.radius_A = 7; })); },
                 {"radius", "7 Å", "three lattice constants", "7.38 Å"});
  // The membrane with the card's constants needs atoms too.
  expect_refusal([] { check(changed([](Case& c) { c.radius_A = 7, c.models = Models::membrane; })); }, {"7.38"});
  EXPECT_NO_THROW(check(changed([](Case& c) { c.radius_A = 8, c.tip_radius_A = 3, c.depth_step_A = 1; })));
}

TEST(Check, HugeSheetsOfAtoms) {
  const auto huge = changed([](Case& c) { c.radius_A = 5000; });
  expect_refusal([&] { check(huge); }, {"radius", "5000 Å", "3000 Å", "--models membrane"});
  auto membrane_only = huge;
  membrane_only.models = Models::membrane;
  EXPECT_TRUE(check(membrane_only).empty());
  EXPECT_TRUE(check(changed([](Case& c) { c.radius_A = 1000; })).empty());  // whether it fits is known at the start
}

TEST(Check, GivenConstantsAreOfAnySize) {
  auto c = given_constants();
  for (const double radius : {1e-3, 1.0, 5000.0, 6e9}) {
    c.radius_A = radius;
    c.tip_radius_A = radius / 100;
    c.depth_step_A = radius / 100;
    EXPECT_TRUE(check(c).empty()) << radius;
  }
}

TEST(Check, GivenConstantsAreAllThreeOrNone) {
  auto c = given_constants();
  c.nu.reset();
  expect_refusal([&] { check(c); }, {"E, thickness", "missing: nu"});
  c.thickness_A.reset();
  expect_refusal([&] { check(c, {{"E", "--E"}}); }, {"--E:", "missing: thickness, nu"});
  c = given_constants();
  c.E_eV_per_A3.reset();
  expect_refusal([&] { check(c); }, {"missing: E"});
}

TEST(Check, GivenConstantsNeedTheMembraneAlone) {
  for (const Models models : {Models::both, Models::atomistic}) {
    auto c = given_constants();
    c.models = models;
    expect_refusal([&] { check(c); }, {"E, thickness, nu", "--models membrane", std::string(to_string(models))});
  }
}

TEST(Check, TipWiderThanTheSheet) {
  auto c = changed([](Case& wide) { wide.tip_radius_A = 110; });
  expect_refusal(
      [&] {
        check(c, {{"tip-radius", "case.toml:7: tip-radius"}});
      },
      {"case.toml:7: tip-radius", "110 Å", "wider than the sheet"});
  c.loads = {LoadKind::point};  // then there is no tip
  EXPECT_NO_THROW(check(c));
}

TEST(Check, TipWithoutAtoms) {
  const auto c = changed([](Case& narrow) { narrow.tip_radius_A = 1; });
  expect_refusal([&] { check(c); }, {"tip-radius", "1 Å", "no atom", "1.5 Å"});
}

TEST(Check, DepthBeyondTheRadius) {
  expect_refusal([] { check(changed([](Case& c) { c.depth_max_A = 111; })); }, {"depth-max", "111 Å", "radius, 110 Å"});
}

TEST(Check, WarnsFromHalfTheRadius) {
  EXPECT_TRUE(check(changed([](Case& c) { c.depth_max_A = 54.9; })).empty());
  const auto warnings = check(changed([](Case& c) { c.depth_max_A = 55; }), {{"depth-max", "--depth-max"}});
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("--depth-max: 55 Å"), std::string::npos) << warnings[0];
}

TEST(Check, DepthStep) {
  expect_refusal([] { check(changed([](Case& c) { c.depth_step_A = 25; })); },
                 {"depth-step", "25 Å", "24.2 Å", "0.22 of the radius"});
  expect_refusal([] { check(changed([](Case& c) { c.depth_step_A = 1e-5; })); },
                 {"depth-step", "2420000 levels", "at most 10000"});
}

TEST(Check, ForcesReplaceDepths) {
  const auto warnings = check(changed([](Case& c) {
    c.forces_eV_per_A = {4, 1, 2};
    c.depth_max_A = 500;
  }));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("not used"), std::string::npos);
  expect_refusal([] { check(changed([](Case& c) { c.forces_eV_per_A.assign(10001, 1); })); },
                 {"forces", "10001 levels", "at most 10000"});
}

TEST(Check, PretensionThatBreaksTheSheet) {
  expect_refusal([] { check(changed([](Case& c) { c.pretension_eV_per_A2 = 3; })); },
                 {"pretension", "3 eV/Å²", "2.6 eV/Å²"});
}

TEST(Check, Loads) {
  expect_refusal([] { check(changed([](Case& c) { c.loads = {}; })); }, {"loads", "at least one"});
  expect_refusal([] { check(changed([](Case& c) {
                        c.loads = {LoadKind::disc, LoadKind::point, LoadKind::disc};
                      })); },
                 {"loads", "'disc' is named twice"});
}

TEST(Check, Window) {
  for (const auto& window : {std::vector<double>{0.1}, {0.15, 0.10}, {0.1, 0.1}, {0.1, 0.2, 0.3}, {}}) {
    expect_refusal([&] { check(changed([&](Case& c) { c.window = window; })); }, {"window", "two increasing"});
  }
}

}  // namespace
