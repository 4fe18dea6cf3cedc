// The plane problems in closed form, each against the problem it solves.
#include <gsl/gsl_integration.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "reference/annulus_torsion.hpp"
#include "reference/bent_strip.hpp"
#include "reference/convergence.hpp"
#include "reference/foppl_disc.hpp"
#include "reference/shallow_tip.hpp"
#include "reference/sheet_states.hpp"
#include "reference/shooting.hpp"

namespace reference {
namespace {

TEST(AnnulusTorsion, HasTheKnownTorques) {
  EXPECT_NEAR(annulus_torsion(1.5).torque, 5.37684, 5e-6);
  EXPECT_NEAR(annulus_torsion(2).torque, 3.67804, 5e-6);
  EXPECT_NEAR(annulus_torsion(3).torque, 2.70797, 5e-6);
}

TEST(AnnulusTorsion, SolvesItsBoundaryValueProblem) {
  for (const double b : {1.2, 1.5, 2.0, 3.0}) {
    const AnnulusTorsion formula = annulus_torsion(b), shot = annulus_torsion_by_shooting(b);
    EXPECT_NEAR(shot.torque / formula.torque, 1, 1e-11) << b;
    EXPECT_NEAR(shot.tangent / formula.tangent, 1, 1e-10) << b;
    EXPECT_NEAR(shot.largest_nu / formula.largest_nu, 1, 1e-10) << b;
  }
  testing::expect_converges([](int steps) { return annulus_torsion_by_shooting(3, steps).torque; }, 8, 6, 1e-14);
}

// Resultants of fibres that bear tension only, e = e0 + κ y over |y| ≤ ½, by quadrature.
TEST(BentStrip, BalancesForceAndMoment) {
  const auto resultant = [](double e0, double curvature, int power) {
    const auto fibre = [&](double y) { return std::max(e0 + curvature * y, 0.0) * std::pow(y, power); };
    double sum = 0;  // Gauss, in 4000 parts
    gsl_integration_glfixed_table* rule = gsl_integration_glfixed_table_alloc(4);
    auto callable = [](double y, void* f) { return (*static_cast<const decltype(fibre)*>(f))(y); };
    gsl_function function{callable, const_cast<void*>(static_cast<const void*>(&fibre))};
    for (int i = 0; i < 4000; ++i)
      sum += gsl_integration_glfixed(&function, -0.5 + i / 4000.0, -0.5 + (i + 1) / 4000.0, rule);
    gsl_integration_glfixed_table_free(rule);
    return sum;
  };
  for (const double moment : {0.05, 1.0 / 6, 0.2, 0.25, 1.0 / 3, 0.4, 0.45}) {
    const double curvature = bent_strip_curvature(moment);  // P = E·h = H = 1
    const double e0 = root([&](double e) { return resultant(e, curvature, 0) - 1; }, -curvature / 2, curvature / 2 + 1);
    EXPECT_NEAR(resultant(e0, curvature, 1), moment, 1e-6) << moment;
    EXPECT_NEAR(std::max(0.0, 0.5 - e0 / curvature), bent_strip_band(moment), 1e-6) << moment;
  }
}

// Stein & Hedgepeth 1961: 2 M/(P H) = 1 − ⅔ √(2 P/(E·h κ H²)).
TEST(BentStrip, HasThePublishedMomentCurvatureRelation) {
  for (const double moment : {1.0 / 6, 0.25, 0.4})
    EXPECT_NEAR(2 * moment, 1 - 2.0 / 3 * std::sqrt(2 / bent_strip_curvature(moment)), 1e-14);
}

// Energy 1/(2 (1 − nu²)) (Ē1² + Ē2² + 2 nu Ē1 Ē2) at E·h = 1.
double force_across(double nu, double pretension, double along, double across) {
  const double E0 = (1 - nu) * pretension;
  return ((across * across - 1) / 2 + E0 + nu * ((along * along - 1) / 2 + E0)) / (1 - nu * nu);
}

TEST(SheetStates, NaturalWidthHasNoForceAcross) {
  for (const double pretension : {0.0, 0.02}) {
    EXPECT_NEAR(force_across(0.19, pretension, 1.1, natural_width(0.19, 1.1, pretension)), 0, 1e-15);
  }
  EXPECT_DOUBLE_EQ(natural_width(0.19, 1.1), std::sqrt(1 - 0.19 * 0.21));
}

TEST(SheetStates, ShearIsTheLargerPrincipalStrain) {
  EXPECT_NEAR(simple_shear_wrinkled_force(0.1), 0.0525625, 5e-8);
  for (const double shear : {0.01, 0.1, 1.0}) {  // det(E − S1 I) = 0
    const double S1 = simple_shear_wrinkled_force(shear);
    EXPECT_NEAR((0 - S1) * (shear * shear / 2 - S1) - shear * shear / 4, 0, 1e-15);
    EXPECT_GT(S1, shear * shear / 4);  // the larger of both
  }
}

// The natural width at the slack stretch is that stretch itself: nothing is left to bear.
TEST(SheetStates, SlackWhereEvenTheNaturalWidthIsFree) {
  for (const double nu : {0.0, 0.19, 0.45}) {
    const double stretch = slack_stretch(nu, 0.02);
    EXPECT_NEAR(natural_width(nu, stretch, 0.02), stretch, 1e-15);
    EXPECT_NEAR(force_across(nu, 0.02, stretch, stretch), 0, 1e-15);
  }
}

TEST(ShallowTip, IsTheTightLimitOfTheDisc) {
  for (const double c : {0.02, 1.0 / 11, 1.0}) {
    const FopplDepth depth = foppl_disc({0.3, c, 0.01}, 1e-8);
    EXPECT_NEAR(1e-8 / (0.01 * depth.centre) / shallow_disc_stiffness(c), 1, 1e-6) << c;
    EXPECT_NEAR(1e-8 / (0.01 * depth.conjugate) / shallow_disc_conjugate_stiffness(c), 1, 1e-6) << c;
  }
}

}  // namespace
}  // namespace reference
