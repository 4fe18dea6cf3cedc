#include "compare/base/nearest.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <string_view>

namespace {

using namespace validate;

constexpr std::array<std::string_view, 5> names = {"radius", "tip-radius", "depth-max", "depth-step", "nu"};

TEST(Nearest, FindsTypingErrors) {
  EXPECT_EQ(nearest("radus", names), "radius");    // left out
  EXPECT_EQ(nearest("raadius", names), "radius");  // doubled
  EXPECT_EQ(nearest("rdaius", names), "radius");   // swapped
  EXPECT_EQ(nearest("tip_radius", names), "tip-radius");
  EXPECT_EQ(nearest("RADIUS", names), "radius");
  EXPECT_EQ(nearest("depth-stp", names), "depth-step");
  EXPECT_EQ(nearest("nv", names), "nu");
}

TEST(Nearest, ASwapIsOneError) {  // two would be too many for two letters
  constexpr std::array<std::string_view, 1> short_name = {"nu"};
  EXPECT_EQ(nearest("un", short_name), "nu");
}

TEST(Nearest, TakesAnAbbreviation) { EXPECT_EQ(nearest("tip", names), "tip-radius"); }

TEST(Nearest, FarNamesHaveNone) {
  EXPECT_FALSE(nearest("temperature", names));
  EXPECT_FALSE(nearest("", names));
  EXPECT_FALSE(nearest("radius", {}));
  EXPECT_FALSE(nearest(std::string(100000, 'r'), names));
}

TEST(Nearest, IsASentenceForMessages) {
  EXPECT_EQ(did_you_mean("radus", names), "; did you mean 'radius'?");
  EXPECT_EQ(did_you_mean("temperature", names), "");
}

}  // namespace
