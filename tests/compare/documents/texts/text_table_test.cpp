#include "compare/documents/texts/text_table.hpp"

#include <gtest/gtest.h>

using namespace validate;

namespace {

TextTable sample() {
  TextTable table({{.heading = "load", .align = Align::left},
                   {.heading = "force", .unit = "eV/Å"},
                   {.heading = "note", .align = Align::left, .rank = 2},
                   {.heading = "points", .rank = 1}});
  table.add({"disc", "1.50", "as far as it goes", "11"});
  table.add_line("a line across");
  table.add({"point", "12.25"});
  return table;
}

TEST(TextTable, ColumnsAreAsWideAsTheirCells) {
  EXPECT_EQ(sample().text(120),
            "load   force  note               points\n"
            "        eV/Å\n"
            "disc    1.50  as far as it goes      11\n"
            "a line across\n"
            "point  12.25\n");
}

TEST(TextTable, TheLeastColumnsGoFirstAndAreNamed) {
  EXPECT_EQ(sample().text(30),
            "load   force  points\n"
            "        eV/Å\n"
            "disc    1.50      11\n"
            "a line across\n"
            "point  12.25\n"
            "--wide also shows: note\n");
  EXPECT_EQ(sample().text(15).substr(0, 13), "load   force\n");
  EXPECT_NE(sample().text(15).find("--wide also shows: note, points\n"), std::string::npos);
}

TEST(TextTable, ColumnsWithoutARankStayHoweverShortTheLine) {
  EXPECT_EQ(sample().text(5).substr(0, 13), "load   force\n");
}

}  // namespace
