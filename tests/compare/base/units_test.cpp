#include "compare/base/units.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "compare/base/describe.hpp"
#include "compare/base/field_value.hpp"
#include "tests/compare/support.hpp"

namespace {

using namespace validate;
using compare_tests::expect_refusal;

struct Example {
  std::string text;
  std::string_view unit;
  double expected;
};

// 1 eV/Å = 1.602176634 nN, 1 eV/Å² = 16.02176634 N/m, 1 eV/Å³ = 160.2176634 GPa (CODATA 2018, exact)
const Example examples[] = {
    {"110", unit::length, 110},
    {"+110", unit::length, 110},
    {" 1.1e2 ", unit::length, 110},
    {"110 A", unit::length, 110},
    {"110 Å", unit::length, 110},
    {"110 \u212b", unit::length, 110},
    {"110A\u030a", unit::length, 110},
    {"110 angstrom", unit::length, 110},
    {"11 nm", unit::length, 110},
    {"11nm", unit::length, 110},
    {"0.5 um", unit::length, 5000},
    {"0.5 µm", unit::length, 5000},
    {"0.5 \u03bcm", unit::length, 5000},
    {"335 pm", unit::length, 3.35},
    {"1 mm", unit::length, 1e7},
    {"0.6 m", unit::length, 6e9},
    {"4", unit::force, 4},
    {"4 eV/A", unit::force, 4},
    {"4 eV / Å", unit::force, 4},
    {"4 meV/A", unit::force, 0.004},
    {"1.602176634 nN", unit::force, 1},
    {"1602.176634 pN", unit::force, 1},
    {"1.602176634e-3 uN", unit::force, 1},
    {"1.602176634e-6 mN", unit::force, 1},
    {"1.602176634e-9 N", unit::force, 1},
    {"2 eV/A^2", unit::membrane_force, 2},
    {"2 eV/Å²", unit::membrane_force, 2},
    {"2 eV/A**2", unit::membrane_force, 2},
    {"2000 meV/Å²", unit::membrane_force, 2},
    {"200 eV/nm^2", unit::membrane_force, 2},
    {"16.02176634 N/m", unit::membrane_force, 1},
    {"16.02176634 J/m²", unit::membrane_force, 1},
    {"16021.76634 mN/m", unit::membrane_force, 1},
    {"1.602176634e7 µN/m", unit::membrane_force, 1},
    {"0.01602176634 kN/m", unit::membrane_force, 1},
    {"3 eV/A^3", unit::stress, 3},
    {"3 eV/Å³", unit::stress, 3},
    {"3000 eV/nm³", unit::stress, 3},
    {"0.1602176634 TPa", unit::stress, 1},
    {"160.2176634 GPa", unit::stress, 1},
    {"160217.6634 MPa", unit::stress, 1},
    {"160217663.4 kPa", unit::stress, 1},
    {"160217663400 Pa", unit::stress, 1},
    {"160217663400 N/m^2", unit::stress, 1},
    {"0.19", unit::none, 0.19},
    {"-0.158", unit::none, -0.158},
};

TEST(Units, TextBecomesBaseUnits) {
  for (const auto& [text, base, expected] : examples) {
    EXPECT_NEAR(parse_quantity(text, base, "--x"), expected, 1e-14 * std::abs(expected)) << text;
  }
}

TEST(Units, EveryUnitOfEveryQuantityIsUnderstood) {
  for (const auto base : {unit::length, unit::force, unit::membrane_force, unit::stress}) {
    EXPECT_DOUBLE_EQ(parse_quantity("7 " + std::string(base), base, "--x"), 7) << base;
    for (const Unit& u : quantity_of(base).units) {
      EXPECT_DOUBLE_EQ(parse_quantity("2 " + std::string(u.name), base, "--x"), 2 * u.in_base) << u.name;
    }
  }
}

TEST(Units, UnknownUnitNamesAllowedAndNearest) {
  expect_refusal([] { parse_quantity("11 nmm", unit::length, "case.toml:3: radius"); },
                 {"case.toml:3: radius", "'11 nmm'", "unknown unit 'nmm'", "length", "A, pm, nm, um, mm, m",
                  "did you mean 'nm'?"});
  expect_refusal([] { parse_quantity("1 Gpa", unit::stress, "--E"); }, {"--E", "did you mean 'GPa'?"});
  expect_refusal([] { parse_quantity("1 nn", unit::force, "--forces"); }, {"did you mean 'nN'?"});
}

TEST(Units, UnitOfAnotherQuantityIsRefused) {
  expect_refusal([] { parse_quantity("0.34 N", unit::membrane_force, "--pretension"); },
                 {"--pretension", "unknown unit 'N'", "membrane force", "N/m"});
  expect_refusal([] { parse_quantity("0.19 nm", unit::none, "--nu"); }, {"--nu", "without a unit", "'nm'"});
}

TEST(Units, WhatIsNotANumberIsRefused) {
  for (const char* text : {"", " ", "nm", "ten", "--5", "- 5", "x5"}) {
    expect_refusal([&] { parse_quantity(text, unit::length, "--radius"); }, {"--radius", "not a length", "nm"});
  }
  expect_refusal([] { parse_quantity("ten", unit::none, "--nu"); }, {"--nu", "'ten'", "expected a number"});
  expect_refusal([] { parse_quantity("1,5 nm", unit::length, "--radius"); }, {"unknown unit ',5 nm'"});
  expect_refusal([] { parse_quantity("1e999", unit::length, "--radius"); }, {"--radius", "1e999", "too large"});
}

TEST(Units, RangesRefuseNanAndInfinity) {
  const Field field{"radius", unit::length, "", positive()};
  for (const char* text : {"nan", "inf", "-inf", "0", "-3", "-0.0", "1e300 m"}) {
    expect_refusal([&] { parse_number(field, text, "--radius"); }, {"--radius", "> 0 Å"});
  }
  const Field free_field{"x", unit::length};
  expect_refusal([&] { parse_number(free_field, "inf", "--x"); }, {"any finite number"});
  EXPECT_EQ(parse_number(free_field, "-3", "--x"), -3);
}

TEST(Units, RangesHaveOpenAndClosedEnds) {
  const Field open{"nu", {}, "", between(-1, 1)};
  expect_refusal([&] { in_range(open, 1, "--nu"); }, {"--nu: 1 ", "> -1 and < 1"});
  expect_refusal([&] { in_range(open, -1, "--nu"); }, {"> -1 and < 1"});
  const Field closed{"x", {}, "", from_to(0, 1)};
  EXPECT_EQ(in_range(closed, 1, "--x"), 1);
  EXPECT_EQ(in_range(closed, 0, "--x"), 0);
  expect_refusal([&] { in_range(closed, 1.01, "--x"); }, {">= 0 and <= 1"});
}

TEST(Units, LaboratoryUnitsAreToldFromAtomicOnes) {
  for (const char* text : {"11 nm", "0.5um", "0.5 µm", "1 mm", "100 nN", "3 pN", "1 N"})
    EXPECT_TRUE(in_laboratory_units(text)) << text;
  for (const char* text :
       {"110", "110 A", "110 Å", "4 eV/A", "142 pm", "0.34 N/m", "1 TPa", "nm", "", "disc", "5 feet"})
    EXPECT_FALSE(in_laboratory_units(text)) << text;
}

TEST(Units, ABaseUnitThatIsNeverReadIsAProgrammingError) { EXPECT_THROW(quantity_of(unit::second), std::logic_error); }

}  // namespace
