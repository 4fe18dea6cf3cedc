#include "atomistic/thermal/hessian.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "atomistic/equilibrium/indentation.hpp"
#include "atomistic/thermal/modes.hpp"
#include "tests/atomistic/support/paths.hpp"

namespace {

using namespace atomistic;
using Eigen::VectorXd;

/// A sheet, pressed into a bowl so that nothing is symmetric by chance, and its gradient through LAMMPS.
class Pressed {
 public:
  Pressed(const std::string& name, double radius_A, double depth_A, double strain = 0)
      : problem_(problem_of(name, radius_A, DiscLoad{5}, {1})),
        sheet_(make_sheet_at(strain)),
        forces_(problem_.potential, box_around(sheet_), sheet_.positions, "none"),
        positions_(sheet_.positions) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal(0, depth_A > 0 ? 0.01 : 0);
    for (int i = 0; i < sheet_.free_atoms; ++i) {
      const double r = sheet_.position(i).head<2>().norm() / radius_A;
      positions_[3 * i + 2] -= depth_A * (1 - r * r);
      for (int c = 0; c < 3; ++c) positions_[3 * i + c] += normal(random);
    }
  }

  const Sheet& sheet() const { return sheet_; }
  const Card& card() const { return problem_.card; }
  VectorXd free() const { return positions_.head(3 * sheet_.free_atoms); }
  double energy(const VectorXd& x) {
    positions_.head(x.size()) = x;
    return forces_.evaluate(positions_, atom_forces_);
  }
  VectorXd gradient(const VectorXd& x) {
    energy(x);
    return -atom_forces_.head(x.size());
  }
  Gradient function() {
    return [this](const VectorXd& x) { return gradient(x); };
  }

 private:
  Sheet make_sheet_at(double strain) {
    problem_.biaxial_strain = strain;
    return make_sheet(problem_);
  }

  Problem problem_;
  Sheet sheet_;
  ForceField forces_;
  VectorXd positions_, atom_forces_;
};

TEST(Coupling, AtomsOfAColourShareNoNeighbour) {
  const Sheet sheet = make_sheet(15, 2.46, 0, 5);
  for (const int reach : {1, 2, 3}) {
    const Coupling coupling(sheet, reach);
    for (int i = 0; i < coupling.atoms(); ++i) {
      std::vector<int> colours;
      for (const int j : coupling.coupled(i)) colours.push_back(coupling.colour(j));
      std::sort(colours.begin(), colours.end());
      ASSERT_EQ(std::adjacent_find(colours.begin(), colours.end()), colours.end()) << "reach " << reach;
    }
    const auto around = coupling.coupled(sheet.innermost.front()).size();  // none of them can share a colour
    EXPECT_LE(coupling.colours(), 2 * static_cast<int>(around)) << "reach " << reach;
  }
}

class HessianOf : public testing::TestWithParam<std::pair<std::string, int>> {};

/// A pattern as wide as the potential reaches reproduces any direction; one that is narrower does not.
TEST_P(HessianOf, ReproducesTheForcesAndTheEnergy) {
  const auto [name, reach] = GetParam();
  Pressed sheet(name, 10, 2);
  const VectorXd x = sheet.free();
  const Hessian made = hessian(sheet.function(), Coupling(sheet.sheet(), reach), x);
  EXPECT_LT(made.asymmetry_relative, 1e-6);
  EXPECT_LT(missed_by(made, sheet.function(), x), 1e-5);
  const Hessian narrow = hessian(sheet.function(), Coupling(sheet.sheet(), reach - 1), x);
  EXPECT_GT(missed_by(narrow, sheet.function(), x), 1e-3);

  const VectorXd v = VectorXd::Random(x.size());
  const double step = 2e-3, here = sheet.energy(x);
  const double second = (sheet.energy(x + step * v) - 2 * here + sheet.energy(x - step * v)) / (step * step);
  EXPECT_NEAR(v.dot(made.matrix * v), second, 2e-3 * second);
}

/// A translation of all atoms costs nothing: the rows of atoms that see no held one sum to nothing.
TEST_P(HessianOf, IsInvariantUnderTranslations) {
  const auto [name, reach] = GetParam();
  Pressed sheet(name, 14, 2);
  const Hessian made = hessian(sheet.function(), Coupling(sheet.sheet(), reach), sheet.free());
  const int inner = sheet.sheet().innermost.front();
  for (int axis = 0; axis < 3; ++axis) {
    VectorXd all = VectorXd::Zero(made.matrix.rows());
    for (int i = 0; i < sheet.sheet().free_atoms; ++i) all[3 * i + axis] = 1;
    EXPECT_LT((made.matrix * all).segment<3>(3 * inner).norm(), 1e-5) << axis;
  }
}

INSTANTIATE_TEST_SUITE_P(Hessian, HessianOf,
                         testing::Values(std::pair<std::string, int>("tersoff", 2),
                                         std::pair<std::string, int>("rebo", 3)),
                         [](const auto& test) { return test.param.first; });

/// λ = κ A_atom k⁴ with k a = 3.19622 (k²a² = 10.2158), the lowest mode of a clamped plate: the sheet's softest.
TEST(Modes, OfAFlatSheetAreThoseOfAClampedPlate) {
  Pressed sheet("tersoff", 30, 0);
  const Hessian made = hessian(sheet.function(), Coupling(sheet.sheet(), 2), sheet.free());
  const Eigenpairs modes = lowest_modes(made.matrix, 3);
  const double a = std::sqrt(sheet.sheet().free_atoms * sheet.card().area_per_atom_A2() / M_PI) +
                   sheet.card().clamp_margin_bonds * sheet.card().bond_A();
  const double slope = sheet.card().slope_margin_bonds * sheet.card().bond_A();
  const auto plate = [&](double frequency, double radius) {
    return sheet.card().bending_modulus_eV() * sheet.card().area_per_atom_A2() * std::pow(frequency, 2) /
           std::pow(radius, 4);
  };
  // Slopes are held farther out than displacements: the mode lies between the plates of both radii.
  EXPECT_GT(modes.values[0], plate(10.2158, a + slope));
  EXPECT_LT(modes.values[0], plate(10.2158, a));
  EXPECT_NEAR(modes.values[1], modes.values[2], 1e-5 * modes.values[1]);  // cos φ and sin φ
  EXPECT_NEAR(modes.values[1] / modes.values[0], std::pow(21.2604 / 10.2158, 2), 0.02 * 4.33);
}

/// Under a strong tension τ the lowest mode is a membrane's, λ = τ A_atom (2.40483/a)², with bending's share left.
TEST(Modes, OfAStretchedSheetAreThoseOfAMembrane) {
  constexpr double strain = 0.03;
  Pressed sheet("tersoff", 40, 0, strain);
  const Hessian made = hessian(sheet.function(), Coupling(sheet.sheet(), 2), sheet.free());
  const Eigenpairs modes = lowest_modes(made.matrix, 1);
  const double area = sheet.card().area_per_atom_A2() * std::pow(1 + strain, 2);
  const double a =
      std::sqrt(sheet.sheet().free_atoms * area / M_PI) + sheet.card().clamp_margin_bonds * sheet.card().bond_A();
  const double tau = (sheet.card().C11_eV_per_A2 + sheet.card().C12_eV_per_A2) * strain *
                     (1 - sheet.card().bond_softening * strain / 2);
  const double kappa = sheet.card().bending_modulus_eV(), membrane = tau * std::pow(2.40483 / a, 2);
  // A clamped membrane that also bends: the boundary layer √(κ/τ) shortens the radius by its width.
  const double shorter = tau * std::pow(2.40483 / (a - std::sqrt(kappa / tau)), 2);
  EXPECT_GT(modes.values[0] / area, membrane);
  EXPECT_NEAR(modes.values[0] / area, shorter, 0.06 * shorter);
}

TEST(Modes, FindsANegativeEigenvalue) {
  Pressed sheet("tersoff", 30, 0, -0.01);  // far beyond the buckling strain of a clamped disc
  const Hessian made = hessian(sheet.function(), Coupling(sheet.sheet(), 2), sheet.free());
  const Eigenpairs modes = lowest_modes(made.matrix, 1);
  EXPECT_LT(modes.values[0], 0);
  EXPECT_NEAR((made.matrix * modes.vectors[0] - modes.values[0] * modes.vectors[0]).norm(), 0, 1e-4);
}

}  // namespace
