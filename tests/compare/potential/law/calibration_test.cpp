#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "compare/potential/law/calibrated_law.hpp"
#include "compare/potential/law/linear_fit.hpp"
#include "compare/potential/law/states.hpp"
#include "compare/potential/law/variants.hpp"

namespace validate {
namespace {

constexpr double bond_A = 1.42;

atomistic::Card card() {
  atomistic::Card c;
  c.a0_A = bond_A * std::numbers::sqrt3;
  c.C11_eV_per_A2 = 20;
  c.C12_eV_per_A2 = 5;
  c.C66_eV_per_A2 = 7.5;
  return c;
}

/// What a lattice would answer whose energy is ¼ (C11 + C12) I² + (C11 − C12) q² + c3 I³ + c q³ − d I² q², written out
/// by hand, with a bond along the larger strain.
atomistic::HomogeneousState answer(const atomistic::StrainState& strain) {
  const double I = strain.E11 + strain.E22, q = (strain.E11 - strain.E22) / 2;
  const double W_I = 0.5 * 25 * I - 3 * 4 * I * I - 2 * 40 * I * q * q;
  const double W_q = 2 * 15 * q - 3 * 17 * q * q - 2 * 40 * I * I * q;
  atomistic::HomogeneousState s;
  s.strain = strain;
  s.S11_eV_per_A2 = W_I + W_q / 2;
  s.S22_eV_per_A2 = W_I - W_q / 2;
  s.longest_bond_A = bond_A * (1 + 0.5 * I + 0.6 * q - 0.4 * I * q);
  s.converged = true;
  return s;
}

const CalibrationRange usual = calibration_range(1.70);

std::vector<atomistic::HomogeneousState> answers(const CalibrationRange& range = usual) {
  std::vector<atomistic::HomogeneousState> states;
  for (const atomistic::StrainState& strain : calibration_strains(bond_A, range)) states.push_back(answer(strain));
  return states;
}

TEST(LinearFit, IsTheWeightedLineOfTheNormalEquations) {
  Eigen::MatrixXd X(4, 2);
  X << 1, 0, 1, 1, 1, 2, 1, 4;
  const Eigen::Vector4d y(1, 2.5, 2, 6), w(1, 2, 0.5, 4);
  const Eigen::MatrixXd normal = X.transpose() * w.asDiagonal() * X;
  const Eigen::VectorXd expected = normal.inverse() * (X.transpose() * w.asDiagonal() * y);
  const LinearFit fit = linear_fit(X, y, w);
  EXPECT_LT((fit.coefficients - expected).norm(), 1e-12);
  const Eigen::VectorXd r = y - X * expected;
  const double scatter = r.dot(w.asDiagonal() * r) / 2;
  EXPECT_NEAR(fit.standard_errors[1], std::sqrt(scatter * normal.inverse()(1, 1)), 1e-12);
}

TEST(LinearFit, RefusesWhatDoesNotDetermineIt) {
  EXPECT_THROW(linear_fit(Eigen::MatrixXd::Ones(2, 2), Eigen::Vector2d::Ones(), Eigen::Vector2d::Ones()),
               std::invalid_argument);
  EXPECT_THROW(linear_fit(Eigen::MatrixXd::Ones(4, 2), Eigen::Vector4d::Ones(), Eigen::Vector4d::Ones()),
               std::invalid_argument);
}

TEST(Calibration, StatesCoverTheRangeAtThreeAngles) {
  const auto longest_A = [](const std::vector<atomistic::StrainState>& strains) {
    double largest = 0;
    for (const auto& s : strains) largest = std::max(largest, s.E11);
    return std::sqrt(1 + 2 * largest) * bond_A;
  };
  EXPECT_EQ(calibration_strains(bond_A, usual).size(), 176u);
  EXPECT_NEAR(longest_A(calibration_strains(bond_A, usual)), 1.66, 1e-12);
  // a switch that is moved adds states beyond, and leaves the others where they were
  const auto farther = calibration_strains(bond_A, calibration_range(1.92));
  EXPECT_NEAR(longest_A(farther), 1.88, 1e-12);
  for (const auto& s : calibration_strains(bond_A, usual))
    EXPECT_EQ(std::ranges::count_if(farther,
                                    [&](const auto& f) {
                                      return f.E11 == s.E11 && f.E22 == s.E22 && f.orientation_deg == s.orientation_deg;
                                    }),
              1);
}

TEST(Calibration, ReachesAsFarAsThePotentialBearsAndNoFarther) {
  EXPECT_NEAR(usual.holds_A, 1.66, 1e-12);
  EXPECT_NEAR(usual.fitted_A, 1.68, 1e-12);
  EXPECT_NEAR(calibration_range(1.92).holds_A, 1.88, 1e-12);
  EXPECT_NEAR(calibration_range(1.92).fitted_A, 1.90, 1e-12);
  EXPECT_NEAR(calibration_range(2.5).fitted_A, 1.90, 1e-12);
  EXPECT_NEAR(calibration_range(1.6).fitted_A, 1.58, 1e-12);
}

/// What the lattice cannot bear, in one direction of the three, says nothing of its longest bond.
TEST(Calibration, FitsALawFartherAndLeavesOutWhatTheLatticeDoesNotBear) {
  const CalibrationRange far = calibration_range(1.92);
  std::vector<atomistic::HomogeneousState> states = answers(far);
  int lost = 0;
  for (auto& s : states) {
    if (!(s.strain.E11 + s.strain.E22 > 0.5) || s.strain.orientation_deg == zigzag_deg) continue;
    s.converged = false;
    s.S11_eV_per_A2 = -100;
    s.longest_bond_A = 1.5;
    ++lost;
  }
  ASSERT_GT(lost, 10);
  const CalibratedLaw found = calibrate(card(), states, far);
  EXPECT_LT(found.worst_misfit, 1e-8);
  EXPECT_LT(found.longest_bond.worst_misfit_A, 1e-8);
  EXPECT_TRUE(found.within(0.25, 0.1));
  EXPECT_FALSE(calibrate(card(), answers(), usual).within(0.25, 0.1));
}

TEST(Calibration, FindsTheCoefficientsOfAPolynomialSheet) {
  const CalibratedLaw found = calibrate(card(), answers(), usual);
  EXPECT_EQ(found.law.terms.size(), 33u);  // 3 + 4 + … + 8
  EXPECT_NEAR(found.law.sheet_modulus_eV_per_A2, 20 - 25.0 / 20, 1e-12);
  for (const auto& [a, b, c] : found.law.terms) {
    double expected = 0;
    if (a == 3 && b == 0) expected = -4;
    if (a == 0 && b == 3) expected = -17;
    if (a == 2 && b == 2) expected = -40;
    EXPECT_NEAR(c, expected, 1e-5) << a << ' ' << b;
  }
  EXPECT_LT(found.worst_misfit, 1e-10);
  EXPECT_LT(found.anisotropy, 1e-12);
}

TEST(Calibration, LongestBondFollowsFromTheStrain) {
  const CalibratedLaw found = calibrate(card(), answers(), usual);
  EXPECT_LT(found.longest_bond.worst_misfit_A, 1e-10);
  EXPECT_NEAR(found.longest_bond(0.03, 0.11), answer({0.11, 0.03, 0, 0}).longest_bond_A, 1e-9);
  EXPECT_TRUE(found.within(0.05, -0.02));
  EXPECT_FALSE(found.within(0.05, -0.05));
  EXPECT_FALSE(found.within(0.4, 0.4));
}

TEST(Calibration, TellsWhereTheLawIsNotConvex) {
  EXPECT_TRUE(calibrate(card(), answers(), usual).convexity.convex());
  std::vector<atomistic::HomogeneousState> softened = answers();
  for (auto& s : softened) {
    const double I = s.strain.E11 + s.strain.E22;
    s.S11_eV_per_A2 -= 60 * I * I;
    s.S22_eV_per_A2 -= 60 * I * I;
  }
  const Convexity convexity = calibrate(card(), softened, usual).convexity;
  EXPECT_FALSE(convexity.convex());
  EXPECT_GT(convexity.E1 + convexity.E2, 0.05);
}

TEST(Calibration, RefusesTooFewStates) {
  std::vector<atomistic::HomogeneousState> few = answers();
  for (std::size_t i = 16; i < few.size(); ++i) few[i].converged = false;
  EXPECT_THROW(calibrate(card(), few, usual), std::invalid_argument);
  EXPECT_NO_THROW(calibrate(card(), answers(), usual, 5));
}

TEST(Calibration, EveryFormGivesThePolynomialSheet) {
  // An isotropic sheet of fourth degree: the table, the sixfold form and the polynomials from 5 on hold it exactly.
  for (const LawVariant& form : law_variants(card(), answers(), usual)) {
    EXPECT_LT(form.worst_misfit, 1e-6) << form.name;
    EXPECT_LT(form.force_difference, 1e-5) << form.name;
  }
}

TEST(Calibration, TheSixfoldFormFindsADirection) {
  std::vector<atomistic::HomogeneousState> states = answers();
  for (auto& s : states) {  // + 30 q³ cos 6θ
    const double q = (s.strain.E11 - s.strain.E22) / 2, turn = 6 * s.strain.orientation_deg * std::numbers::pi / 180;
    s.S11_eV_per_A2 += 45 * q * q * std::cos(turn);
    s.S22_eV_per_A2 -= 45 * q * q * std::cos(turn);
    s.S12_eV_per_A2 += -45 * q * q * std::sin(turn);  // dW/dφ of the doubled angle over 2 q
  }
  const membrane::CauchyBornSixfold law = calibrate_sixfold(card(), states, usual);
  for (auto& s : states) {
    membrane::CauchyBornSixfold turned = law;
    turned.zigzag_rad = -s.strain.orientation_deg * std::numbers::pi / 180;
    const auto force = turned({s.strain.E11, s.strain.E22, 0}).force_eV_per_A2;
    EXPECT_NEAR(force[0], s.S11_eV_per_A2, 1e-6);
    EXPECT_NEAR(force[1], s.S22_eV_per_A2, 1e-6);
    EXPECT_NEAR(force[2], s.S12_eV_per_A2, 1e-6);
  }
  for (const LawVariant& form : law_variants(card(), states, usual)) {
    if (form.name != "sixfold") continue;
    EXPECT_LT(form.worst_misfit, 1e-6);
  }
}

}  // namespace
}  // namespace validate
