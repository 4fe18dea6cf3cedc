// What the page's script is given.
#include "compare/documents/page/page.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "compare/documents/bytes/base64.hpp"
#include "compare/documents/page/packed.hpp"
#include "compare/documents/page/plot_json.hpp"
#include "compare/documents/page/sheets_json.hpp"
#include "tests/compare/results/complete_result.hpp"
#include "tests/compare/results/sample_result.hpp"

using namespace validate;

namespace {

using nlohmann::json;

TEST(Base64, FollowsTheTestVectors) {  // of RFC 4648
  for (const auto& [bytes, text] :
       {std::pair{"", ""}, {"f", "Zg=="}, {"fo", "Zm8="}, {"foo", "Zm9v"}, {"foobar", "Zm9vYmFy"}})
    EXPECT_EQ(base64(bytes), text);
}

/// By hand: 0, −1, 3 are the codes 0, 1, 6, of 7 in all: one bit of each is written as it is.
TEST(Packed, IsRicesCode) {
  EXPECT_EQ(packed({{0, -1, 3}}), "CPA=");  // 00001, then 0 0, 0 1, 1110 0, and zeros to the byte's end
  EXPECT_EQ(packed({{}}), "");
}

TEST(Packed, WhatGoesOnEvenlyTakesOneBitANumber) {
  std::vector<std::vector<std::int32_t>> frames;
  for (int f = 0; f < 100; ++f) {
    std::vector<std::int32_t>& frame = frames.emplace_back();
    for (int i = 0; i < 320; ++i) frame.push_back(1000 * i * (f + 1));
  }
  const std::size_t bits = 98 * (320 + 10 * 5);  // of all frames but the first two
  EXPECT_LT(packed(frames).size(), bits / 6 + 2000);
}

TEST(PlotJson, HoldsWhatIsDrawn) {
  Panel panel{.title = "t", .x = {.label = "depth", .unit = "Å", .low = 0}, .y = {.label = "F", .logarithmic = true}};
  panel.curves = {{.name = "a \"quoted\" name",
                   .x = {1.23456789, -2e-9, 0},
                   .y = {NAN, 1e300, INFINITY},
                   .colour = Colour::blue,
                   .line = Line{Dash::dashed, 2}}};
  panel.zones = {{.from = 3, .name = "zone"}};
  panel.marks = {{.along = Along::y, .at = 1}};
  panel.labels = {{.text = "here", .x = 1, .y = 2, .colour = Colour::green}};
  const json plot = json::parse(plot_json({.panels = {panel}, .columns = 1}));
  const json& drawn = plot["panels"][0];
  EXPECT_EQ(drawn["curves"][0]["name"], "a \"quoted\" name");
  EXPECT_EQ(drawn["curves"][0]["x"], (json{1.23457, -2e-9, 0}));
  EXPECT_EQ(drawn["curves"][0]["y"], (json{nullptr, 1e300, nullptr}));
  EXPECT_EQ(drawn["curves"][0]["line"]["dash"], "7 4");
  EXPECT_FALSE(drawn["curves"][0].contains("points"));
  EXPECT_EQ(drawn["x"]["text"], "depth (Å)");
  EXPECT_EQ(drawn["x"]["low"], 0);
  EXPECT_TRUE(drawn["x"]["high"].is_null());
  EXPECT_TRUE(drawn["zones"][0]["to"].is_null()) << "to the panel's end";
  EXPECT_EQ(drawn["marks"][0]["along"], "y");
  EXPECT_EQ(drawn["labels"][0]["text"], "here");
}

TEST(PlotJson, MapsAreNoCharts) {
  EXPECT_FALSE(is_chart({}));
  EXPECT_TRUE(is_chart({.panels = {Panel{}}}));
  EXPECT_FALSE(is_chart({.panels = {Panel{.curves = {{.name = "", .x = {0}, .y = {0}, .value = {1}}}}}}));
}

AtomsTrajectory trajectory(std::size_t atoms, std::size_t frames) {
  std::mt19937 random(1);
  AtomsTrajectory t{.load = "disc", .atoms = atoms, .free_atoms = atoms};
  for (std::size_t f = 0; f < frames; ++f) {
    t.depth_A.push_back(static_cast<double>(f)), t.force_eV_per_A.push_back(static_cast<double>(f * f));
    for (std::size_t i = 0; i < 3 * atoms; ++i) t.positions_A.push_back(static_cast<float>(random() % 1000) / 100);
  }
  return t;
}

Result of_disc() {
  Result result = sample::membrane_only();
  result.runs.clear();
  result.resolved.loads = {LoadKind::disc};
  result.resolved.judged_load = LoadKind::disc;
  return result;
}

TEST(SheetsJson, IsEmptyWhereNothingWasKept) { EXPECT_EQ(sheets_json(of_disc(), {}), ""); }

/// What a file may lack.
TEST(SheetsJson, PassesOverIncompletePictures) {
  Result result = of_disc();
  validate::Run& run = result.runs.emplace_back();
  SheetPicture picture = sample::picture();
  run.load = LoadKind::disc, run.constants = Constants::card;
  run.continuum().pictures = std::make_shared<const std::vector<SheetPicture>>(1, picture);
  EXPECT_EQ(sheets_json(result, {}), "") << "of no depth";
  picture.totals.push_back({.key = "depth_A", .value = 3});
  run.continuum().pictures = std::make_shared<const std::vector<SheetPicture>>(1, picture);
  EXPECT_NE(sheets_json(result, {}), "");
  picture.displacement.pop_back();
  run.continuum().pictures = std::make_shared<const std::vector<SheetPicture>>(1, picture);
  EXPECT_EQ(sheets_json(result, {}), "");
}

TEST(SheetsJson, HoldsTheAtomsOfTheLoad) {
  const json sheets = json::parse(sheets_json(of_disc(), {trajectory(50, 6)}));
  EXPECT_EQ(sheets["loads"][0]["load"], "disc");
  EXPECT_EQ(sheets["loads"][0]["atoms"]["depth"], (json{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(sheets["loads"][0]["atoms"]["every"], 1);
}

TEST(SheetsJson, LeavesDepthsOutWhereThePageWouldGrow) {
  const std::string whole = sheets_json(of_disc(), {trajectory(500, 8)});
  const std::string half = sheets_json(of_disc(), {trajectory(500, 8)}, whole.size() - 1);
  EXPECT_LT(half.size(), whole.size());
  const json atoms = json::parse(half)["loads"][0]["atoms"];
  EXPECT_EQ(atoms["depth"], (json{0, 1, 3, 5, 7})) << "the flat sheet and the deepest stay";
  EXPECT_EQ(atoms["every"], 2);
  EXPECT_EQ(sheets_json(of_disc(), {trajectory(500, 8)}, 100), "") << "no depth fits";
}

}  // namespace
