// The two laws that soften as graphene does: Lee et al. 2008, and the one fitted to a lattice.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "membrane/laws/cauchy_born.hpp"
#include "membrane/laws/lee_graphene.hpp"
#include "states.hpp"

namespace membrane::testing {
namespace {

constexpr double modulus = 342 / 16.02176634;  // E·h and nu as in the source paper's Figure 1
constexpr double nu = 0.165;
const LeeGraphene lee{modulus, nu};

double smallest_stiffness(const Voigt& strain) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(lee(strain).tangent_eV_per_A2).eigenvalues()[0];
}

TEST(LeeGraphene, UniaxialResponseIsThePublishedOne) {
  for (double e : {0.01, 0.1, 0.2, 0.3}) {
    const Response at = lee(Voigt(e, -nu * e, 0));
    EXPECT_NEAR(at.force_eV_per_A2[0], modulus * e + lee.third_order_modulus_eV_per_A2 * e * e, 1e-14);
    EXPECT_NEAR(at.force_eV_per_A2[1], 0, 1e-14);
    const UniaxialResponse along = lee.uniaxial(e);
    EXPECT_NEAR(along.energy_eV_per_A2, at.energy_eV_per_A2, 1e-14);
    EXPECT_NEAR(along.force_eV_per_A2, at.force_eV_per_A2[0], 1e-14);
    EXPECT_NEAR(along.tangent_eV_per_A2, uniaxial_response(lee, e).tangent_eV_per_A2, 1e-13);
  }
}

TEST(LeeGraphene, UniaxialTangentVanishesAtTheStrength) {
  const double strongest = -modulus / (2 * lee.third_order_modulus_eV_per_A2);
  EXPECT_NEAR(strongest, 0.2478, 1e-4);
  EXPECT_NEAR(lee.uniaxial(strongest).tangent_eV_per_A2, 0, 1e-14);
  EXPECT_GT(lee.uniaxial(0.99 * strongest).tangent_eV_per_A2, 0);
  EXPECT_LT(lee.uniaxial(1.01 * strongest).tangent_eV_per_A2, 0);
  // 42 N/m is the breaking strength that the publication reports.
  EXPECT_NEAR(lee.uniaxial(strongest).force_eV_per_A2 * 16.02176634, 42, 0.5);
}

TEST(LeeGraphene, ConvexityEndsInShearUnderEqualBiaxialTension) {
  const double end = -modulus * (1 - nu) / (2 * lee.third_order_modulus_eV_per_A2);
  for (double e : {0.0, 0.5 * end, 0.999 * end}) EXPECT_GT(smallest_stiffness(Voigt(e, e, 0)), 0);
  EXPECT_NEAR(smallest_stiffness(Voigt(end, end, 0)), 0, 1e-13);
  EXPECT_LT(smallest_stiffness(Voigt(1.001 * end, 1.001 * end, 0)), 0);
  // Growth: none. The energy falls without end under tension, and rises under compression.
  EXPECT_LT(lee(Voigt(3, 3, 0)).energy_eV_per_A2, 0);
  EXPECT_GT(lee(Voigt(-0.4, -0.4, 0)).energy_eV_per_A2, 0);
}

TEST(CauchyBorn, WithoutTermsIsStVenantKirchhoffAndWithLeesIsLees) {
  const CauchyBorn bare{modulus, nu, {}};
  const StVenantKirchhoff svk{modulus, nu};
  const double D = lee.third_order_modulus_eV_per_A2;
  const CauchyBorn third{
      modulus, nu, {{3, 0, D * (1 - 3 * nu) / (12 * std::pow(1 - nu, 3))}, {1, 2, D / (1 - nu * nu)}}};
  for (const auto& [name, strain] : named_strains([](double e) { return -nu * e; })) {
    EXPECT_LE((bare(strain).force_eV_per_A2 - svk(strain).force_eV_per_A2).norm(), 1e-14) << name;
    EXPECT_LE((bare(strain).tangent_eV_per_A2 - svk(strain).tangent_eV_per_A2).norm(), 1e-13) << name;
    EXPECT_LE((third(strain).force_eV_per_A2 - lee(strain).force_eV_per_A2).norm(), 1e-14) << name;
    EXPECT_LE((third(strain).tangent_eV_per_A2 - lee(strain).tangent_eV_per_A2).norm(), 1e-13) << name;
  }
  EXPECT_NEAR(third.natural_width(0.1), -nu * 0.1, 1e-15);
}

TEST(CauchyBorn, CubeOfTheShearIsRegularAtRestAndHasItsOwnSign) {
  // c q³ alone: S = (3/2) c q dev E, which must not divide by q.
  const CauchyBorn law{modulus, nu, {{0, 3, 5}}};
  const CauchyBorn bare{modulus, nu, {}};
  EXPECT_EQ(law(Voigt::Zero()).tangent_eV_per_A2, bare(Voigt::Zero()).tangent_eV_per_A2);
  const Voigt strain(0.03, -0.03, 0);
  const Voigt extra = law(strain).force_eV_per_A2 - bare(strain).force_eV_per_A2;
  EXPECT_NEAR(extra[0], 1.5 * 5 * 0.03 * 0.03, 1e-15);
  EXPECT_NEAR(extra[1], -extra[0], 1e-15);
}

TEST(GrapheneLaws, ParametersWithoutMeaningAreRefused) {
  EXPECT_NO_THROW(lee.check());
  EXPECT_THROW((LeeGraphene{0, nu}.check()), std::invalid_argument);
  EXPECT_THROW((LeeGraphene{modulus, 1}.check()), std::invalid_argument);
  EXPECT_THROW((LeeGraphene{modulus, nu, std::nan("")}.check()), std::invalid_argument);
  EXPECT_NO_THROW(some_lattice().check());
  EXPECT_THROW((CauchyBorn{modulus, -1, {}}.check()), std::invalid_argument);
  EXPECT_THROW((CauchyBorn{modulus, nu, {{2, 0, 1}}}.check()), std::invalid_argument);
  EXPECT_THROW((CauchyBorn{modulus, nu, {{-1, 4, 1}}}.check()), std::invalid_argument);
  EXPECT_THROW((CauchyBorn{modulus, nu, {{2, 1, 1}}}.check()), std::invalid_argument);
  EXPECT_THROW((CauchyBorn{modulus, nu, {{5, 4, 1}}}.check()), std::invalid_argument);
  EXPECT_THROW((CauchyBorn{modulus, nu, {{3, 0, INFINITY}}}.check()), std::invalid_argument);
}

}  // namespace
}  // namespace membrane::testing
