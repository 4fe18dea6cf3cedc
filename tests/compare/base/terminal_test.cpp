#include "compare/base/terminal.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

using namespace validate;

namespace {

TEST(Terminal, LongLinesAreBrokenAtBlanks) {
  EXPECT_EQ(wrapped("one two three four", 10), "one two\n    three\n    four");
  EXPECT_EQ(wrapped("  one two three\nfour\n", 11), "  one two\n     three\nfour\n");
  EXPECT_EQ(wrapped("short\n\n  lines\n", 20), "short\n\n  lines\n");
}

TEST(Terminal, FurtherLinesBeginWhereTheSecondColumnDoes) {
  EXPECT_EQ(wrapped("--flag   tells of it at length", 18), "--flag   tells of\n         it at\n         length");
}

TEST(Terminal, APathStaysWhole) {
  const std::string path = "/a/very/long/path/to/somewhere";
  EXPECT_EQ(wrapped(path, 10), path);
  EXPECT_EQ(wrapped("wrote " + path + " at once", 20), "wrote\n    " + path + "\n    at once");
}

TEST(Terminal, CharactersAreCountedNotBytes) {
  EXPECT_EQ(width_of("ÅÅ ±"), 4);
  EXPECT_EQ(wrapped("ÅÅÅ ÅÅÅ", 7), "ÅÅÅ ÅÅÅ");
  EXPECT_EQ(cut_to("ÅÅÅÅÅÅ", 4), "ÅÅÅ…");
  EXPECT_EQ(cut_to("ÅÅÅÅ", 4), "ÅÅÅÅ");
}

TEST(Terminal, WithoutATerminalALineHasEightyCharactersAtMost) {
  testing::internal::CaptureStdout();  // a file now
  ::unsetenv("COLUMNS");
  const int none = line_width();
  ::setenv("COLUMNS", "200", 1);
  const int many = line_width();
  ::setenv("COLUMNS", "60", 1);
  const int few = line_width();
  ::setenv("COLUMNS", "3", 1);
  const int too_few = line_width();
  ::setenv("COLUMNS", "wide", 1);
  const int no_number = line_width();
  ::unsetenv("COLUMNS");
  testing::internal::GetCapturedStdout();
  EXPECT_EQ(none, 80);
  EXPECT_EQ(many, 80);
  EXPECT_EQ(few, 60);
  EXPECT_EQ(too_few, 40);
  EXPECT_EQ(no_number, 80);
}

}  // namespace
