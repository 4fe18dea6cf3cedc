#include "atomistic/lattice/sheet.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "atomistic/lattice/ripple.hpp"

namespace {

using namespace atomistic;

constexpr double a0 = 2.46;

TEST(Sheet, HexagonCentredWithSixAtomsAtOneBondFromTheAxis) {
  const Sheet sheet = make_sheet(20, a0, 0, 6);
  ASSERT_EQ(sheet.record.size(), 6u);
  EXPECT_EQ(sheet.innermost, sheet.record);
  for (int atom : sheet.record) EXPECT_NEAR(sheet.position(atom).norm(), a0 / std::numbers::sqrt3, 1e-12);
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

TEST(Sheet, AtomCentred) {
  SheetForm form;
  form.centre = Centre::atom;
  const Sheet sheet = make_sheet(20, a0, 0, 6, form);
  ASSERT_EQ(sheet.innermost.size(), 1u);
  EXPECT_LT(sheet.position(sheet.innermost[0]).norm(), 1e-12);
  ASSERT_EQ(sheet.record.size(), 3u);
  for (int atom : sheet.record) EXPECT_NEAR(sheet.position(atom).norm(), a0 / std::numbers::sqrt3, 1e-12);
}

TEST(Sheet, RotationTurnsTheLatticeNotTheEdge) {
  SheetForm form;
  form.rotation_deg = 17;
  const Sheet turned = make_sheet(20, a0, 0, 6, form), straight = make_sheet(20, a0, 0, 6);
  ASSERT_EQ(turned.atoms(), straight.atoms());
  ASSERT_EQ(turned.free_atoms, straight.free_atoms);
  const Eigen::Matrix2d turn = Eigen::Rotation2D<double>(17 * std::numbers::pi / 180).toRotationMatrix();
  for (int i = 0; i < straight.atoms(); ++i)
    EXPECT_LT((turned.position(i).head<2>() - turn * straight.position(i).head<2>()).norm(), 1e-12);
}

std::vector<std::size_t> ring_sizes(const Sheet& sheet) {
  std::vector<std::size_t> counts(20);
  for (const auto& ring : rings(sheet)) ++counts.at(ring.size());
  return counts;
}

TEST(Sheet, PerfectRingsAreHexagonsThatTileTheDisc) {
  const Sheet sheet = make_sheet(20, a0, 0, 6);
  const auto counts = ring_sizes(sheet);
  EXPECT_EQ(counts[6], rings(sheet).size());
  std::vector<int> met(sheet.free_atoms);
  for (const auto& ring : rings(sheet))
    for (int atom : ring)
      if (atom < sheet.free_atoms) ++met[atom];
  for (int times : met) EXPECT_EQ(times, 3);
}

TEST(Sheet, VacancyLeavesAHoleOfTwelve) {
  SheetForm form;
  form.vacancies = {{8, 3}};
  const Sheet sheet = make_sheet(20, a0, 0, 6, form), whole = make_sheet(20, a0, 0, 6);
  EXPECT_EQ(sheet.atoms(), whole.atoms() - 1);
  EXPECT_EQ(sheet.free_atoms, whole.free_atoms - 1);
  EXPECT_EQ(sheet.bonds.size(), whole.bonds.size() - 3);
  EXPECT_EQ(ring_sizes(sheet)[12], 1u);
}

TEST(Sheet, StoneWalesMakesTwoPentagonsAndTwoHeptagons) {
  SheetForm form;
  form.stone_wales = {{0, 1.2}};
  const Sheet sheet = make_sheet(20, a0, 0, 6, form), whole = make_sheet(20, a0, 0, 6);
  EXPECT_EQ(sheet.atoms(), whole.atoms());
  EXPECT_EQ(sheet.bonds.size(), whole.bonds.size());
  const auto counts = ring_sizes(sheet), perfect = ring_sizes(whole);
  EXPECT_EQ(counts[5], 2u);
  EXPECT_EQ(counts[7], 2u);
  EXPECT_EQ(counts[6], perfect[6] - 4);
  for (int i = 0; i < sheet.free_atoms; ++i)
    for (int j : sheet.neighbours[i]) EXPECT_GT((sheet.position(i) - sheet.position(j)).norm(), 0.6 * sheet.bond_A);
}

TEST(Sheet, SlidingSquareEndsWithoutDanglingAtoms) {
  SheetForm form;
  form.shape = Shape::square;
  form.edge = Edge::sliding;
  const Sheet sheet = make_sheet(20, a0, 0, 6, form);
  EXPECT_EQ(sheet.atoms(), sheet.free_atoms);
  ASSERT_EQ(sheet.slides.size(), static_cast<std::size_t>(sheet.atoms()));
  for (int i = 0; i < sheet.atoms(); ++i) {
    const auto bonds = 3 - std::count(sheet.neighbours[i].begin(), sheet.neighbours[i].end(), -1);
    EXPECT_GE(bonds, 2);
    EXPECT_EQ(sheet.slides[i], bonds < 3);
    EXPECT_LE(sheet.position(i).head<2>().cwiseAbs().maxCoeff(), 20);
  }
}

TEST(Sheet, ClampedSquareHasARing) {
  SheetForm form;
  form.shape = Shape::square;
  const Sheet sheet = make_sheet(20, a0, 0, 6, form);
  for (int i = 0; i < sheet.atoms(); ++i) {
    const double far = sheet.position(i).head<2>().cwiseAbs().maxCoeff();
    EXPECT_EQ(far <= 20, i < sheet.free_atoms);
    EXPECT_LE(far, 26);
  }
  EXPECT_TRUE(sheet.slides.empty());
}

TEST(Sheet, RefusesDefectsThatCannotBe) {
  SheetForm form;
  form.vacancies = {{25, 0}};
  EXPECT_THROW(make_sheet(20, a0, 0, 6, form), std::invalid_argument);
  form.vacancies = {{0.7, 1.2}, {1.4, 0}, {0.7, -1.2}, {-0.7, 1.2}, {-1.4, 0}, {-0.7, -1.2}};
  EXPECT_THROW(make_sheet(20, a0, 0, 6, form), std::invalid_argument) << "nothing left at the axis";
  form.vacancies.clear();
  form.stone_wales = {{5, 1.2}, {5, 1.2}, {19.9, 0}};
  EXPECT_NO_THROW(make_sheet(20, a0, 0, 6, form));
}

TEST(Sheet, RefusesSheetsThatAreTooSmallOrNotNumbers) {
  EXPECT_THROW(make_sheet(2.9 * a0, a0, 0, 5), std::invalid_argument);
  EXPECT_THROW(make_sheet(NAN, a0, 0, 5), std::invalid_argument);
  EXPECT_THROW(make_sheet(20, a0, 0, 0), std::invalid_argument);
}

TEST(Ripple, HasItsSizeVanishesAtTheEdgeAndComesAgain) {
  const SheetForm square{.shape = Shape::square, .edge = Edge::sliding};
  const Sheet sheet = make_sheet(25, 2.46, 0, 5, square);
  const Eigen::VectorXd u = ripple(sheet, 0.4, 3);
  ASSERT_EQ(u.size(), 3 * sheet.free_atoms);
  double squares = 0;
  for (int i = 0; i < sheet.free_atoms; ++i) {
    EXPECT_EQ(u.segment<2>(3 * i).norm(), 0);
    const double edge = 25 - sheet.position(i).head<2>().cwiseAbs().maxCoeff();
    if (edge < 0.5) {
      EXPECT_LT(std::abs(u[3 * i + 2]), 0.3);
    }
    squares += u[3 * i + 2] * u[3 * i + 2];
  }
  EXPECT_NEAR(std::sqrt(squares / sheet.free_atoms), 0.4, 1e-12);
  EXPECT_EQ(u, ripple(sheet, 0.4, 3));
  EXPECT_GT((u - ripple(sheet, 0.4, 4)).norm(), 1);
}

}  // namespace
