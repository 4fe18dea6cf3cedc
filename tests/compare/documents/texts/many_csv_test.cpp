// curves.csv of many fits: what is written is read again.
#include "compare/documents/texts/many_csv.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace {

using namespace validate;

TEST(ManyCsv, ARowIsReadAsItWasWritten) {
  CurveRow row{.file = "a, \"b\".ibw", .index = 7, .skipped = "slip or break: 3 nN"};
  row.Eh_eV_per_A2 = 21.3;
  row.height_A = -1234.5;
  row.points = 500;
  const CurveRow again = many_csv_read(many_csv_row(row));
  EXPECT_EQ(again.file, row.file);
  EXPECT_EQ(again.index, 7);
  EXPECT_EQ(again.skipped, row.skipped);
  EXPECT_NEAR(again.Eh_eV_per_A2, 21.3, 1e-8);
  EXPECT_NEAR(again.height_A, -1234.5, 1e-6);
  EXPECT_TRUE(std::isnan(again.pretension_eV_per_A2));
  EXPECT_EQ(again.points, 500);
}

TEST(ManyCsv, NamesHaveTheUnitsOfTheirNumbers) {
  CurveRow row{.file = "f"};
  row.Eh_eV_per_A2 = 1;
  EXPECT_NE(many_csv_header().find(",Eh_N_per_m,"), std::string::npos);
  EXPECT_NE(many_csv_row(row).find(",16.0217"), std::string::npos) << many_csv_row(row);
}

TEST(ManyCsv, ALineCutShortIsNone) {
  const std::string line = many_csv_row(CurveRow{.file = "f"});
  EXPECT_THROW(many_csv_read(line.substr(0, line.size() / 2)), std::invalid_argument);
  EXPECT_THROW(many_csv_read(line + ",1"), std::invalid_argument);
  EXPECT_THROW(many_csv_read("\"" + line), std::invalid_argument);
}

}  // namespace
