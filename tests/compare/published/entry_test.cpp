#include "compare/published/entry.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/compare/support.hpp"

namespace validate::published {
namespace {

using compare_tests::expect_refusal;
using compare_tests::TemporaryFolder;

const std::string good =
    "# mine\n"
    "[[row]]\n"
    "name = \"modulus\"\n"
    "quantity = \"Eh\"\n"
    "published = 0.335\n"
    "uncertainty = 0.008\n"
    "unit = \"kN/m\"\n"
    "conditions = \"300 K\"\n"
    "comparable = false\n"
    "reason = \"300 K\"\n"
    "source = \"lab book\"\n";

std::string with(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

void expect_refused(const std::string& text, const std::vector<std::string>& words) {
  const TemporaryFolder folder;
  const auto file = folder.write("mine.toml", text);
  expect_refusal([&] { read_entries(file, "--file"); }, words);
}

TEST(PublishedFile, ARowIsReadWithItsUnit) {
  const TemporaryFolder folder;
  const auto entries =
      read_entries(folder.write("mine.toml", good + "potentials = [\"tersoff\", \"mine.toml\"]\n"), "");
  ASSERT_EQ(entries.size(), 1u);
  EXPECT_EQ(entries[0].quantity, Subject::sheet_modulus);
  EXPECT_EQ(entries[0].potentials.size(), 2u);
  EXPECT_NEAR(unit_in_base(entries[0]), 1000 / 16.02176634, 1e-9);
}

TEST(PublishedFile, WhatIsWrongIsNamedWithItsLine) {
  expect_refused(with(good, "Eh", "Eg"), {"mine.toml:4", "quantity", "Eg", "did you mean 'Eh'?"});
  expect_refused(with(good, "uncertainty = 0.008", "uncertainty = -1"), {"mine.toml:6", "uncertainty"});
  expect_refused(with(good, "conditions", "condition"), {"mine.toml:8", "did you mean 'conditions'?"});
  expect_refused(with(good, "kN/m", "kN"), {"mine.toml:2", "unit", "kN/m"});
  expect_refused(with(good, "published = 0.335\n", ""), {"mine.toml:2", "lacks the key 'published'"});
  expect_refused(with(good, "reason = \"300 K\"\n", ""), {"lacks the key 'reason'"});
  expect_refused(with(good, "comparable = false", "comparable = true"), {"has the key 'reason'"});
  expect_refused(good + "nu = 0.2\n", {"'nu'", "'Eh' does not take"});
  expect_refused(good + "relation = \">=\"\n", {"'uncertainty'", "bound"});
  expect_refused(with(good, "\"Eh\"", "\"hencky\""), {"'nu'", "needs it"});
  expect_refused("name = 1\n" + good, {"mine.toml:1", "stands outside of [[row]]"});
  expect_refused(with(good, "[[row]]", "[[rows]]"), {"mine.toml:2", "did you mean 'row'?"});
  expect_refused(with(good, "[[row]]", "[row]"), {"mine.toml:2", "list of tables"});
  expect_refused("# nothing\n", {"mine.toml", "no [[row]]"});
}

/// Every row says where it comes from, and what both numbers do not share.
TEST(PublishedFile, TheShippedOneIsReadAndTellsOnlyWhatIsPublished) {
  const auto entries = read_entries(VALIDATE_SOURCE_INPUTS "/published.toml", "");
  EXPECT_GE(entries.size(), 25u);
  std::set<std::string> names;
  for (const Entry& e : entries) {
    EXPECT_TRUE(names.insert(e.name).second) << e.name << " occurs twice";
    EXPECT_FALSE(e.source.empty());
    EXPECT_TRUE(e.comparable || !e.reason.empty()) << e.name;
    if (e.conditions.find("300 K") != std::string::npos) {
      EXPECT_FALSE(e.comparable) << e.name;
    }
  }
  const auto nicholl =
      std::ranges::find_if(entries, [](const Entry& e) { return e.quantity == Subject::biaxial_stiffness; });
  ASSERT_NE(nicholl, entries.end());
  EXPECT_EQ(nicholl->published, 428);
  EXPECT_EQ(nicholl->uncertainty, 10);
  EXPECT_EQ(nicholl->arxiv, "1705.08032");
}

}  // namespace
}  // namespace validate::published
