#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "atomistic/lammps/lammps.hpp"
#include "atomistic/lattice/sheet.hpp"
#include "tests/atomistic/support/lammps_session.hpp"

namespace {

using namespace atomistic;
using Eigen::VectorXd;

Box box_of(const Sheet& sheet) {
  const double a = sheet.positions.cwiseAbs().maxCoeff() + 5;
  return {.low = {-a, -a, -30}, .high = {a, a, 30}};
}

/// Stretched and rippled, so that no force vanishes by symmetry.
VectorXd deformed(const Sheet& sheet) {
  VectorXd x = sheet.positions;
  for (int i = 0; i < sheet.atoms(); ++i) {
    x[3 * i + 2] = -2 * std::cos(0.2 * x[3 * i]) * std::cos(0.17 * x[3 * i + 1]);
    x[3 * i] *= 1.02;
  }
  return x;
}

class ForcesOf : public testing::TestWithParam<std::string> {};

/// The clamped ring is as wide as the potential reaches: a wider one changes no force on a free atom.
TEST_P(ForcesOf, DoNotFeelTheOuterEdge) {
  const Potential p = potential(GetParam());
  VectorXd forces[2];
  int free_atoms = 0;
  for (int wider : {0, 1}) {
    const Sheet sheet = make_sheet(15, 2.46, 0, p.interaction_range_A + 6 * wider);
    free_atoms = sheet.free_atoms;
    ForceField field(p, box_of(sheet), sheet.positions, "none");
    field.evaluate(deformed(sheet), forces[wider]);
  }
  EXPECT_LT((forces[0] - forces[1].head(forces[0].size())).head(3 * free_atoms).cwiseAbs().maxCoeff(), 1e-10);
}

/// −dE/dx by central differences of second order: halving the step must quarter the error.
TEST_P(ForcesOf, AreTheEnergysGradient) {
  const Sheet sheet = make_sheet(10, 2.46, 0, 6);
  ForceField field(potential(GetParam()), box_of(sheet), sheet.positions, "none");
  const VectorXd x = deformed(sheet);
  VectorXd forces, unused;
  field.evaluate(x, forces);
  VectorXd direction = VectorXd::Zero(x.size());
  for (int k = 0; k < 3 * sheet.free_atoms; ++k) direction[k] = std::sin(1.7 * k);
  const auto error = [&](double h) {
    const double slope =
        (field.evaluate(x + h * direction, unused) - field.evaluate(x - h * direction, unused)) / (2 * h);
    return std::abs(slope + forces.dot(direction));
  };
  const double coarse = error(4e-3), fine = error(2e-3);
  EXPECT_NEAR(coarse / fine, 4, 0.5) << coarse << " " << fine;
}

/// An evaluation after many others equals a fresh one: no history in the neighbour list.
TEST_P(ForcesOf, DependOnThePositionsAlone) {
  const Sheet sheet = make_sheet(10, 2.46, 0, 6);
  ForceField field(potential(GetParam()), box_of(sheet), sheet.positions, "none");
  VectorXd later, fresh, unused;
  for (double part : {0.3, 0.6, 0.9})
    field.evaluate(sheet.positions + part * (deformed(sheet) - sheet.positions), unused);
  const double energy = field.evaluate(deformed(sheet), later);
  EXPECT_NEAR(field.evaluate(deformed(sheet), fresh, true), energy, 1e-9 * std::abs(energy));
  EXPECT_LT((later - fresh).cwiseAbs().maxCoeff(), 1e-10);
}

/// The atoms' virials sum to the stress of the cell, which LAMMPS computes from its global virial; and asking for them
/// changes nothing that comes after.
TEST_P(ForcesOf, HaveVirialsThatSumToTheCellsStress) {
  const double a = 2.46 * 1.03, b = std::sqrt(3.0) * a * 0.99;
  const Box box{.low = {0, 0, -10}, .high = {4 * a, 3 * b, 10}, .tilt_xy = 0, .periodic = true};
  VectorXd x(3 * 48);
  const double cell[4][2] = {{0, 0}, {0, 1.0 / 3}, {0.5, 0.5}, {0.5, 5.0 / 6}};
  int n = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 3; ++j)
      for (const auto& at : cell) {
        x.segment<3>(3 * n) << (i + at[0]) * a, (j + at[1]) * b, 0.05 * std::sin(1.3 * n);
        ++n;
      }
  ForceField field(potential(GetParam()), box, x, "none");
  VectorXd before, after;
  field.evaluate(x, before);
  const Eigen::Matrix2d expected = field.membrane_force();
  const VectorXd virials = field.virials(x);
  ASSERT_EQ(virials.size(), 6 * 48);
  Eigen::Map<const Eigen::Matrix<double, 6, Eigen::Dynamic>> by_atom(virials.data(), 6, 48);
  const Eigen::Matrix<double, 6, 1> sum = by_atom.rowwise().sum() / (4 * a * 3 * b);
  const double scale = expected.norm();
  EXPECT_GT(scale, 0.1);
  EXPECT_NEAR(sum[0], expected(0, 0), 1e-6 * scale);
  EXPECT_NEAR(sum[1], expected(1, 1), 1e-6 * scale);
  EXPECT_NEAR(sum[3], expected(0, 1), 1e-6 * scale);
  field.evaluate(x, after, true);
  EXPECT_EQ(field.membrane_force(), expected);
  EXPECT_LT((after - before).cwiseAbs().maxCoeff(), 1e-10);
}

INSTANTIATE_TEST_SUITE_P(Shipped, ForcesOf, testing::ValuesIn(shipped_potentials()), test_name);

TEST(ForceField, PositionsThatAreNotFiniteNeverReachLammps) {
  const Sheet sheet = make_sheet(10, 2.46, 0, 6);
  ForceField field(potential("tersoff"), box_of(sheet), sheet.positions, "none");
  VectorXd x = sheet.positions, forces;
  x[5] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(field.evaluate(x, forces), std::runtime_error);
  EXPECT_EQ(field.timing().calls, 0);
}

}  // namespace
