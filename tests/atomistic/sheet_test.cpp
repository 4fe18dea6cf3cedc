#include "atomistic/sheet.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace {

using namespace atomistic;

constexpr double a0 = 2.46;

TEST(Sheet, HexagonCentredWithSixAtomsAtOneBondFromTheAxis) {
  const Sheet sheet = make_sheet(20, a0, 0, 6);
  for (int atom : sheet.hexagon) EXPECT_NEAR(sheet.position(atom).norm(), a0 / std::numbers::sqrt3, 1e-12);
  EXPECT_EQ(atoms_within(sheet, 0.9 * sheet.bond_A).size(), 0u);
  EXPECT_EQ(atoms_within(sheet, 1.01 * sheet.bond_A).size(), 6u);
}

TEST(Sheet, FreeAtomsFirstAndTheRingOutside) {
  const Sheet sheet = make_sheet(20, a0, 0, 6);
  for (int i = 0; i < sheet.atoms(); ++i) {
    const double r = sheet.position(i).norm();
    EXPECT_EQ(r <= 20, i < sheet.free_atoms);
    EXPECT_LE(r, 26);
  }
}

TEST(Sheet, AtomDensityIsGraphenes) {
  const Sheet sheet = make_sheet(60, a0, 0, 5);
  const double density = sheet.free_atoms / (std::numbers::pi * 60 * 60);
  EXPECT_NEAR(density, 4 / (std::numbers::sqrt3 * a0 * a0), 0.01 * density);
}

TEST(Sheet, EveryFreeAtomHasThreeBondsOfTheBondLength) {
  const Sheet sheet = make_sheet(20, a0, 0.01, 6);
  EXPECT_NEAR(sheet.bond_A, 1.01 * a0 / std::numbers::sqrt3, 1e-12);
  for (int i = 0; i < sheet.free_atoms; ++i)
    for (int j : sheet.neighbours[i]) {
      ASSERT_GE(j, 0);
      EXPECT_NEAR((sheet.position(i) - sheet.position(j)).norm(), sheet.bond_A, 1e-12);
    }
  EXPECT_NEAR(longest_bond(sheet, sheet.positions), sheet.bond_A, 1e-12);
}

TEST(Sheet, BondsAreListedOnceAndTouchAFreeAtom) {
  const Sheet sheet = make_sheet(15, a0, 0, 6);
  auto bonds = sheet.bonds;
  std::sort(bonds.begin(), bonds.end());
  EXPECT_EQ(std::adjacent_find(bonds.begin(), bonds.end()), bonds.end());
  for (const auto& [i, j] : bonds) EXPECT_LT(i, sheet.free_atoms);
  int ends = 0;  // every free atom's three bonds are there
  for (const auto& [i, j] : bonds) ends += 1 + (j < sheet.free_atoms);
  EXPECT_EQ(ends, 3 * sheet.free_atoms);
}

TEST(Sheet, SixfoldSymmetric) {
  const Sheet sheet = make_sheet(25, a0, 0, 5);
  const Eigen::Matrix2d turn = Eigen::Rotation2D<double>(std::numbers::pi / 3).toRotationMatrix();
  for (int i = 0; i < sheet.free_atoms; i += 7) {
    const Eigen::Vector2d image = turn * sheet.position(i).head<2>();
    double nearest = 1;
    for (int j = 0; j < sheet.free_atoms; ++j)
      nearest = std::min(nearest, (sheet.position(j).head<2>() - image).norm());
    EXPECT_LT(nearest, 1e-9);
  }
}

TEST(Sheet, RefusesSheetsThatAreTooSmallOrNotNumbers) {
  EXPECT_THROW(make_sheet(2.9 * a0, a0, 0, 5), std::invalid_argument);
  EXPECT_THROW(make_sheet(NAN, a0, 0, 5), std::invalid_argument);
  EXPECT_THROW(make_sheet(20, a0, 0, 0), std::invalid_argument);
}

}  // namespace
