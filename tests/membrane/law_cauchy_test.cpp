// Thickness and Cauchy stress of plane stress, over all laws and for St Venant–Kirchhoff in closed form.
#include <gtest/gtest.h>

#include "membrane/laws/cauchy.hpp"
#include "membrane/laws/prestress.hpp"
#include "states.hpp"

namespace membrane::testing {
namespace {

const StVenantKirchhoff svk{8.03368, 0.19};

double green(double lambda) { return 0.5 * (lambda * lambda - 1); }

TEST(Thickness, OfStVenantKirchhoffFreesTheFaces) {
  // S33 = lame tr E + 2 mu E33 of the 3-D law with the same modulus and Poisson ratio.
  const double lame = svk.sheet_modulus_eV_per_A2 * svk.nu / ((1 + svk.nu) * (1 - 2 * svk.nu));
  const double mu = svk.sheet_modulus_eV_per_A2 / (2 * (1 + svk.nu));
  for (const auto& [name, strain] : named_strains([](double e) { return -svk.nu * e; })) {
    const double e33 = green(svk.thickness_stretch(strain));
    EXPECT_NEAR(lame * (strain[0] + strain[1] + e33) + 2 * mu * e33, 0, 1e-14) << name;
  }
  EXPECT_TRUE(std::isnan(svk.thickness_stretch(Voigt(2, 2, 0))));
}

TEST(Thickness, FollowsThePoissonRatioAtSmallStrainOrIsNominal) {
  over_laws([]<class L>(const L& law) {
    constexpr bool nominal = std::is_same_v<L, LeeGraphene> || std::is_same_v<L, CauchyBorn> ||
                             std::is_same_v<L, CauchyBornTable> || std::is_same_v<L, CauchyBornSixfold>;
    EXPECT_EQ(law.thickness_stretch(Voigt::Zero()), 1);
    const double e = 1e-6;
    const double slope = (law.thickness_stretch(Voigt(e, e, 0)) - 1) / (2 * e);
    EXPECT_NEAR(slope, nominal ? 0 : -law.nu / (1 - law.nu), 1e-5);
  });
}

TEST(Cauchy, IsLambdaSquaredSOverJ) {
  const double l1 = 1.08;
  const double l2 = 1.03;
  const Voigt strain = principal_at(green(l1), green(l2), 0.7);
  const double l3 = std::sqrt(1 - svk.nu / (1 - svk.nu) * (l1 * l1 + l2 * l2 - 2));
  const Principal S = principal_forces(svk(strain).force_eV_per_A2);
  const Principal cauchy = principal_forces(cauchy_force(svk, strain, Voigt::Zero(), true));
  EXPECT_NEAR(cauchy.larger, l1 * l1 * S.larger / (l1 * l2 * l3), 1e-13);
  EXPECT_NEAR(cauchy.smaller, l2 * l2 * S.smaller / (l1 * l2 * l3), 1e-13);
  EXPECT_NEAR(cauchy.cos_2theta, std::cos(1.4), 1e-12);
}

TEST(Cauchy, OfAWrinkledSheetIsThatOfTheNaturalWidth) {
  const double l1 = 1.1;
  const double l2 = std::sqrt(1 - svk.nu * (l1 * l1 - 1));
  const double l3 = std::sqrt(1 - svk.nu / (1 - svk.nu) * (l1 * l1 + l2 * l2 - 2));
  for (double tuck : {0.95, 0.6, 0.2}) {
    const Voigt strain = principal_at(green(l1), green(tuck), -0.4);
    const Principal cauchy = principal_forces(cauchy_force(svk, strain, Voigt::Zero(), true));
    EXPECT_NEAR(cauchy.larger, l1 / (l2 * l3) * svk.sheet_modulus_eV_per_A2 * green(l1), 1e-13);
    EXPECT_NEAR(cauchy.smaller, 0, 1e-14);
    const Principal bare = principal_forces(cauchy_force(svk, strain, Voigt::Zero(), false));
    EXPECT_LT(bare.smaller, -0.01);
  }
  EXPECT_EQ(cauchy_force(svk, principal_at(-0.01, -0.02, 0.3), Voigt::Zero(), true), Voigt::Zero());
}

TEST(Cauchy, StartsFromThePrestress) {
  const Voigt prestress(0.17592, -0.05864, 0.08796);
  over_laws([&](const auto& law) {
    const Voigt offset = offset_strain(law, prestress);
    EXPECT_LE((cauchy_force(law, Voigt::Zero(), offset, false) - prestress).norm(), 1e-14);
    // Relaxed, the compressive part has wrinkled away: one principal stress is left.
    EXPECT_NEAR(principal_forces(cauchy_force(law, Voigt::Zero(), offset, true)).smaller, 0, 1e-15);
  });
}

}  // namespace
}  // namespace membrane::testing
