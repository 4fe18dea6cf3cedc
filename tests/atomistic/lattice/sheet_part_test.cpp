#include "atomistic/lattice/sheet_part.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace {

using namespace atomistic;

/// Four quarters of a disc, around the axis.
std::vector<int> quarters(const Sheet& sheet) {
  std::vector<int> owner;
  for (int k = 0; k < sheet.free_atoms; ++k)
    owner.push_back((sheet.position(k).x() > 0 ? 1 : 0) + (sheet.position(k).y() > 0 ? 2 : 0));
  return owner;
}

struct Parts : testing::Test {
  Sheet whole = make_sheet(20, 2.46, 0, 4);
  std::vector<int> owner = quarters(whole);
  std::vector<SheetPart> parts = {part_of(whole, owner, 0), part_of(whole, owner, 1), part_of(whole, owner, 2),
                                  part_of(whole, owner, 3)};
};

TEST_F(Parts, HaveEveryFreeAtomAndEveryMarkOnce) {
  std::multiset<int> own, record;
  for (const SheetPart& part : parts) {
    own.insert(part.ids.begin(), part.ids.begin() + part.sheet.free_atoms);
    for (const int atom : part.sheet.record) record.insert(part.ids[atom]);
  }
  EXPECT_EQ(own.size(), static_cast<std::size_t>(whole.free_atoms));
  EXPECT_EQ(std::set<int>(own.begin(), own.end()).size(), own.size());
  EXPECT_EQ(std::vector<int>(record.begin(), record.end()), whole.record);
}

TEST_F(Parts, KnowTheirGhostsOwners) {
  for (const SheetPart& part : parts)
    for (int g = 0; g < part.ghosts; ++g) {
      const SheetPart& theirs = parts[part.owner[g]];
      EXPECT_LT(part.place[g], theirs.sheet.free_atoms);
      EXPECT_EQ(theirs.ids[part.place[g]], part.ids[part.sheet.free_atoms + g]);
    }
}

/// Two bonds from an own atom everything is there, and in its place.
TEST_F(Parts, AreWholeAroundTheirOwnAtoms) {
  for (const SheetPart& part : parts) {
    for (int k = 0; k < part.sheet.atoms(); ++k) EXPECT_EQ(part.sheet.position(k), whole.position(part.ids[k]));
    for (int k = 0; k < part.sheet.free_atoms; ++k)
      for (int p = 0; p < 3; ++p) {
        const int n = part.sheet.neighbours[k][p];
        ASSERT_EQ(part.ids[n], whole.neighbours[part.ids[k]][p]);
        for (int q = 0; q < 3; ++q) {
          const int second = part.sheet.neighbours[n][q], there = whole.neighbours[part.ids[n]][q];
          ASSERT_EQ(second < 0 ? -1 : part.ids[second], there);
        }
      }
  }
}

TEST_F(Parts, HaveTheLongestBondAmongThem) {
  Eigen::VectorXd x = whole.positions;
  x[3 * whole.record[0]] += 0.3;
  double longest = 0;
  for (const SheetPart& part : parts) longest = std::max(longest, longest_bond(part.sheet, part_of(x, part)));
  EXPECT_EQ(longest, longest_bond(whole, x));
}

}  // namespace
