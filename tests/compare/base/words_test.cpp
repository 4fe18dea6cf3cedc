#include "compare/base/words.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "compare/results/result.hpp"

namespace words_tests {

using validate::Word;

enum class Whole { one, two };
constexpr auto words(Whole) { return std::array{Word{Whole::one, "one"}, Word{Whole::two, "two"}}; }

enum class Short { one, two, three };
constexpr auto words(Short) { return std::array{Word{Short::one, "one"}, Word{Short::two, "two"}}; }

enum class Swapped { one, two };
constexpr auto words(Swapped) { return std::array{Word{Swapped::two, "two"}, Word{Swapped::one, "one"}}; }

}  // namespace words_tests

using namespace validate;

namespace {

/// What to_string() asserts when it is compiled.
TEST(Words, AListThatLacksAValueOrHasAnotherOrderIsSeen) {
  EXPECT_TRUE(detail::words_are_complete<words_tests::Whole>());
  EXPECT_FALSE(detail::words_are_complete<words_tests::Short>());
  EXPECT_FALSE(detail::words_are_complete<words_tests::Swapped>());
}

template <class Enum>
class WordsOf : public testing::Test {};
using Types = testing::Types<LoadKind, Shape, Edge, Extent, Models, Against, Centre, Model, Constants, Ended, Outcome,
                             Regime, TipKind, Command>;
TYPED_TEST_SUITE(WordsOf, Types);

TYPED_TEST(WordsOf, LeadThereAndBackAndAreDifferent) {
  std::set<std::string_view> seen;
  for (std::size_t i = 0; i < all_words<TypeParam>.size(); ++i) {
    const auto value = static_cast<TypeParam>(i);
    EXPECT_EQ(from_word<TypeParam>(to_string(value)), value);
    EXPECT_EQ(fmt::format("{}", value), all_words<TypeParam>[i]);
    EXPECT_TRUE(seen.insert(to_string(value)).second) << to_string(value);
  }
  EXPECT_EQ(from_word<TypeParam>("no such word"), std::nullopt);
}

}  // namespace
