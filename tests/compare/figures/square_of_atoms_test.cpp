// What figure 4 reads from a square of atoms: membrane forces by virials, waves along a line.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "compare/figures/undulation.hpp"
#include "compare/figures/virial_field.hpp"

namespace {

using namespace validate;

atomistic::Sheet square() {
  return atomistic::make_sheet(30, 2.46, 0, 5, {.shape = atomistic::Shape::square, .edge = atomistic::Edge::sliding});
}

/// A sheet stretched in its plane and turned in space, every atom with the virial of one membrane force.
atomistic::Step stressed(const atomistic::Sheet& sheet, const Eigen::Vector2d& principal, double stretch,
                         const Eigen::Matrix3d& turn) {
  atomistic::Step step;
  step.positions.resize(sheet.positions.size());
  step.virials.resize(2 * sheet.positions.size());
  const double area = stretch * 0.75 * std::numbers::sqrt3 * sheet.bond_A * sheet.bond_A;
  const Eigen::Matrix3d force =
      turn * Eigen::Vector3d(principal[0], principal[1], 0).asDiagonal() * turn.transpose() * area;
  for (int i = 0; i < sheet.atoms(); ++i) {
    Eigen::Vector3d x = sheet.position(i);
    x.x() *= stretch;
    step.positions.segment<3>(3 * i) = turn * x;
    step.virials.segment<6>(6 * i) << force(0, 0), force(1, 1), force(2, 2), force(0, 1), force(0, 2), force(1, 2);
  }
  return step;
}

TEST(VirialField, GivesBackTheForceOfAnInclinedStretchedSheet) {
  const atomistic::Sheet sheet = square();
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(0.6, Eigen::Vector3d(1, 2, 0).normalized()) * Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()))
          .toRotationMatrix();
  const auto field = virial_field(sheet, stressed(sheet, {0.7, -0.2}, 1.05, turn), 4);
  ASSERT_EQ(field.size(), 16u);
  int atoms = 0;
  for (const VirialCell& cell : field) {
    EXPECT_NEAR(cell.larger_eV_per_A2, 0.7, 1e-12);
    EXPECT_NEAR(cell.smaller_eV_per_A2, -0.2, 1e-12);
    EXPECT_NEAR((cell.corners_A[2] - cell.corners_A[0]).norm(), 15 * std::numbers::sqrt2, 1e-12);
    atoms += cell.atoms;
  }
  EXPECT_EQ(atoms, sheet.free_atoms);
}

TEST(VirialField, NeedsVirials) {
  const atomistic::Sheet sheet = square();
  atomistic::Step step;
  step.positions = sheet.positions;
  EXPECT_THROW(virial_field(sheet, step, 4), std::invalid_argument);
}

TEST(Undulation, FindsAWaveOnASmoothShape) {
  std::vector<double> place, height;
  for (double s = -110; s <= 110; s += 5) {
    place.push_back(s);
    height.push_back(3 - 4e-4 * s * s + 0.01 * s + 0.8 * std::sin(2 * std::numbers::pi * s / 22));
  }
  const Undulation found = undulation_of(place, height);
  EXPECT_NEAR(found.amplitude_A, 0.8, 0.04);
  EXPECT_NEAR(found.wavelength_A, 22, 0.5);
}

TEST(Undulation, ASmoothShapeHasNone) {
  std::vector<double> place, height;
  for (int i = 0; i < 40; ++i) {
    place.push_back(5.0 * i);
    height.push_back(1e-7 * std::pow(5.0 * i - 90, 4));
  }
  EXPECT_LT(undulation_of(place, height).amplitude_A, 1e-9);
  EXPECT_THROW(undulation_of({1, 2, 3}, {0, 0, 0}), std::invalid_argument);
}

}  // namespace
