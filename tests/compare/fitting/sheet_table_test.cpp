// The tabulated membrane against membranes that are solved.
#include "compare/fitting/sheet_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "compare/base/units.hpp"

using namespace validate;

namespace {

struct Tabulated {
  const char* name;
  MembraneTip tip;
  TableRange range;
};

// A graphene drum of 0.5 µm (Lee et al., Science 321 (2008) 385), and 110 Å of a sheet that bends and softens.
constexpr double Eh = 342 / N_per_m_per_eV_per_A2, D = -690 / N_per_m_per_eV_per_A2;
const TableRange drum{900, Eh, 0.005};

Tabulated with(const char* name, MembraneTip tip, TableRange range = drum) { return {name, std::move(tip), range}; }

class SheetTable : public testing::TestWithParam<Tabulated> {
 protected:
  const MembraneTip& tip() const { return GetParam().tip; }
  const TableRange& range() const { return GetParam().range; }
  ForceModel table() const { return sheet_table(tip(), range()); }
};

TEST_P(SheetTable, IsTheSolvedSheetWithinItsStatedError) {
  const ForceModel model = table();
  EXPECT_LT(model.relative_error, 6e-4);
  for (const double share : {0.01, 0.6})
    for (const double factor : {1.0, 1.1}) {
      const double modulus = factor * range().Eh_eV_per_A2, pretension = share * range().pretension_share * modulus;
      const SheetCurve solved = sheet_curve(tip(), law_of(tip(), modulus), pretension,
                                            {0.1 * model.deepest_A, 0.45 * model.deepest_A, 0.9 * model.deepest_A});
      ASSERT_EQ(solved.depth_A.size(), 3u) << solved.ended_early;
      const double deepest = model.at(model.deepest_A, modulus, pretension).force;
      for (std::size_t i = 0; i < 3; ++i) {
        const double force = model.at(solved.depth_A[i], modulus, pretension).force;
        EXPECT_NEAR(force, solved.force_eV_per_A[i], model.relative_error * deepest)
            << share << " " << factor << " " << solved.depth_A[i];
      }
    }
}

TEST_P(SheetTable, GradientIsTheForcesDerivative) {
  const ForceModel model = table();
  const double modulus = 1.03 * range().Eh_eV_per_A2;
  for (const double share : {-0.2, 0.3})
    for (const double part : {0.01, 0.3, 0.8}) {
      const double pretension = share * range().pretension_share * modulus, depth = part * model.deepest_A;
      const ForceAt at = model.at(depth, modulus, pretension);
      const auto derivative = [&](double a, double b, double h) {
        return (model.at(depth, modulus + a, pretension + b).force -
                model.at(depth, modulus - a, pretension - b).force) /
               (2 * h);
      };
      const double h = 1e-5 * modulus, k = 1e-5 * range().pretension_share * modulus;
      EXPECT_NEAR(at.by_Eh, derivative(h, 0, h), 1e-7 * std::abs(at.by_Eh) + 1e-8 * std::abs(at.force) / modulus);
      EXPECT_NEAR(at.by_pretension, derivative(0, k, k), 1e-6 * std::abs(at.by_pretension));
    }
}

// What many depths of one sheet are asked for, with derivatives over the depth, is what one is.
TEST_P(SheetTable, TheCurveIsTheSameFunction) {
  const ForceModel model = table();
  const double modulus = 0.98 * range().Eh_eV_per_A2;
  for (const double share : {-0.1, 0.4}) {
    const double pretension = share * range().pretension_share * modulus;
    const ForceCurve curve = curve_of(model, modulus, pretension);
    for (const double part : {0.005, 0.019, 0.021, 0.1, 0.7, 0.999, 1.03}) {
      const double depth = part * model.deepest_A, h = 1e-5 * depth;
      const ForceAlong along = curve(depth);
      const ForceAt at = model.at(depth, modulus, pretension);
      EXPECT_NEAR(along.value.force, at.force, 1e-11 * std::abs(at.force)) << part;
      EXPECT_NEAR(along.value.by_Eh, at.by_Eh, 1e-10 * std::abs(at.by_Eh)) << part;
      EXPECT_NEAR(along.value.by_pretension, at.by_pretension, 1e-10 * std::abs(at.by_pretension)) << part;
      const ForceAlong up = curve(depth + h), down = curve(depth - h);
      EXPECT_NEAR(along.first.force, (up.value.force - down.value.force) / (2 * h), 1e-6 * std::abs(along.first.force))
          << part;
      EXPECT_NEAR(along.first.by_Eh, (up.value.by_Eh - down.value.by_Eh) / (2 * h),
                  1e-6 * std::abs(along.first.by_Eh) + 1e-8 * std::abs(along.first.force) / modulus)
          << part;
      EXPECT_NEAR(along.first.by_pretension, (up.value.by_pretension - down.value.by_pretension) / (2 * h),
                  1e-6 * std::abs(along.first.by_pretension))
          << part;
      EXPECT_NEAR(along.second, (up.first.force - down.first.force) / (2 * h),
                  1e-5 * std::abs(along.second) + 1e-6 * std::abs(along.first.force) / depth)
          << part;
    }
  }
}

// The calibrated sheet to 24 Å: its law ends near 25.
INSTANTIATE_TEST_SUITE_P(
    Sheets, SheetTable,
    testing::Values(with("point", {5000, 0.165, 0}), with("disc", {5000, 0.165, 165}),
                    with("sphere", {5000, 0.165, 165, 0, true}),
                    with("third_order", {5000, 0.165, 165, 0, false, third_order_physics(0.165, D, 1.4)}),
                    with("bending", {110, 0.165, 10, 1.4, false, third_order_physics(0.165, D, 1.4)}, {20, Eh, 0.005}),
                    with("calibrated",
                         {111.05, 0.3645, 10.08, 1.4, false,
                          calibrated_physics({17.3356, 0.3645, {{3, 0, -15.8}, {1, 2, -60}}}, 0.967, "airebo")},
                         {24, 17.3356, 0.004})),
    [](const auto& test) { return test.param.name; });

// Shallow: the closed form that the table is taken to holds by itself there; deep it does not.
TEST(SheetTables, ShallowForcesAreThoseOfTheLinearSheet) {
  const double pretension = 0.34 / N_per_m_per_eV_per_A2;
  const ForceModel model = sheet_table({5000, 0.165, 165}, drum);
  const double slope = 2 * std::numbers::pi / (std::log(5000.0 / 165) + 0.5);  // of a stretched drum under a disc
  EXPECT_NEAR(model.at(1, Eh, pretension).force / (slope * pretension), 1, 2e-3);
}

TEST(SheetTables, EndsWhereTheLawDoes) {
  MembraneTip tip{5000, 0.165, 165, 0, true, third_order_physics(0.165, -1200 / N_per_m_per_eV_per_A2, 1.4)};
  const double pretension = 0.34 / N_per_m_per_eV_per_A2;
  std::vector<double> depth;
  for (int i = 1; i <= 40; ++i) depth.push_back(25.0 * i);
  const SheetCurve solved = sheet_curve(tip, law_of(tip, Eh), pretension, depth);
  ASSERT_FALSE(solved.ended_early.empty());
  const ForceModel model = sheet_table(tip, {1000, Eh, 1.5 * pretension / Eh});
  // The first of the table's sheets to end is the one of the least E·h, whose D is the largest beside it, and the most
  // pretension.
  const double least = 0.85 * Eh;
  const SheetCurve first = sheet_curve(tip, law_of(tip, least), 1.5 * pretension / Eh * least, depth);
  EXPECT_NEAR(model.deepest_A / first.depth_A.back(), 1, 0.08);
  EXPECT_LT(model.deepest_A, solved.depth_A.back() * 1.08);
  EXPECT_LT(model.deepest_A, 1000);
  const double d = solved.depth_A[solved.depth_A.size() / 2];
  EXPECT_NEAR(model.at(d, Eh, pretension).force / solved.force_eV_per_A[solved.depth_A.size() / 2], 1, 2e-3);
}

// A drum larger by 1 %, its tip too, is the same sheet in larger units of length.
TEST(SheetTables, AnotherTipIsTheDifferenceOfTwoTables) {
  const MembraneTip tip{5000, 0.165, 165}, larger{5050, 0.165, 166.65};
  const double pretension = 0.34 / N_per_m_per_eV_per_A2;
  const ForceModel table = sheet_table(tip, drum), other = with_tip(table, tip, larger, drum);
  for (const double depth : {100.0, 400.0, 850.0})
    EXPECT_NEAR(other.at(depth, Eh, pretension).force / (1.01 * table.at(depth / 1.01, Eh, pretension).force), 1, 2e-5);
}

}  // namespace
