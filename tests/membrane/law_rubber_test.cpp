// Mooney–Rivlin and neo-Hookean: plane stress of their 3-D energies, and the incompressible sheet in closed
// form.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "membrane/laws/mooney_rivlin.hpp"
#include "states.hpp"
#include "taylor.hpp"

namespace membrane::testing {
namespace {

constexpr double modulus = 8.03368;

double green(double lambda) { return 0.5 * (lambda * lambda - 1); }

/// The 3-D energy in principal stretches, written independently of the law.
double energy_3d(const MooneyRivlin& law, double a, double b, double c) {
  const double mu = modulus / (2 * (1 + law.nu));
  const double mu2 = law.second_share * mu;
  const double lame = modulus * law.nu / ((1 + law.nu) * (1 - 2 * law.nu));
  const double J = a * b * c;
  const double I1 = a * a + b * b + c * c;
  const double I2 = a * a * b * b + b * b * c * c + c * c * a * a;
  return 0.5 * (mu - mu2) * (I1 - 3) + 0.5 * mu2 * (I2 - 3) - (mu + mu2) * std::log(J) +
         (0.5 * lame - mu2) * std::log(J) * std::log(J);
}

/// f'(0) by differences of fourth order.
template <class F>
double slope(F f) {
  const double h = 5e-4;
  return (8 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12 * h);
}

TEST(MooneyRivlin, IsPlaneStressOfItsThreeDimensionalEnergy) {
  for (double nu : {-0.158, 0.0, 0.19, 0.45, 0.49})
    for (double share : {0.0, 0.2})
      for (double l1 : {1.0, 1.1, 1.6})
        for (double l2 : {0.9, 1.0, 1.3}) {
          const MooneyRivlin law{modulus, nu, share};
          const Voigt strain(green(l1), green(l2), 0);
          const double l3 = law.thickness_stretch(strain);
          const Response at = law(strain);
          EXPECT_NEAR(at.energy_eV_per_A2, energy_3d(law, l1, l2, l3), 1e-13);
          EXPECT_NEAR(slope([&](double t) { return energy_3d(law, l1, l2, l3 + t); }), 0, 1e-8);
          const double along = slope([&](double t) { return energy_3d(law, l1 + t, l2, l3); });
          EXPECT_NEAR(at.force_eV_per_A2[0], along / l1, 1e-8);
        }
}

TEST(MooneyRivlin, NeoHookeanForceIsTheKnownTensor) {
  for (double nu : {0.0, 0.3, 0.5})
    for (const auto& [name, strain] : named_strains([&](double e) { return -nu * e; })) {
      const MooneyRivlin law = neo_hookean(modulus, nu);
      const Eigen::Matrix2d C{{1 + 2 * strain[0], strain[2]}, {strain[2], 1 + 2 * strain[1]}};
      const double l3 = nu == 0.5 ? 1 / std::sqrt(C.determinant()) : law.thickness_stretch(strain);
      const Eigen::Matrix2d S = modulus / (2 * (1 + nu)) * (Eigen::Matrix2d::Identity() - l3 * l3 * C.inverse());
      const Voigt expected(S(0, 0), S(1, 1), S(0, 1));
      EXPECT_LE((law(strain).force_eV_per_A2 - expected).norm(), 1e-14) << name << ", nu = " << nu;
    }
}

TEST(MooneyRivlin, IncompressibleInClosedForm) {
  const MooneyRivlin law{modulus, 0.5, 0.2};
  const double mu1 = 0.8 * modulus / 3;
  const double mu2 = 0.2 * modulus / 3;
  for (double l : {1.01, 1.2, 2.0, 4.0}) {
    SCOPED_TRACE(l);
    const double scale = modulus * l * l;
    // One axis: P = (l − 1/l²)(µ1 + µ2/l) = l S at the width 1/√l. Both: σ = (l² − 1/l⁴)(µ1 + µ2 l²) = l² S.
    EXPECT_NEAR(law.natural_width(green(l)), green(1 / std::sqrt(l)), 1e-14);
    EXPECT_NEAR(law.uniaxial(green(l)).force_eV_per_A2, (l - 1 / (l * l)) * (mu1 + mu2 / l) / l, 1e-14 * scale);
    const double both = (1 - std::pow(l, -6)) * (mu1 + mu2 * l * l);
    EXPECT_NEAR(law(Voigt(green(l), green(l), 0)).force_eV_per_A2[0], both, 1e-14 * scale);
    EXPECT_NEAR(law.thickness_stretch(Voigt(green(l), green(l), 0)), 1 / (l * l), 1e-15);
  }
}

TEST(MooneyRivlin, WidthAndThicknessAreOneUnderUniaxialTension) {
  for (double nu : {-0.158, 0.0, 0.19, 0.45, 0.5})
    for (double share : {0.0, 0.2})
      for (double e : {1e-6, 0.05, 0.5, 2.0}) {
        const MooneyRivlin law{modulus, nu, share};
        const double width = law.natural_width(e);
        EXPECT_NEAR(std::sqrt(1 + 2 * width), law.thickness_stretch(Voigt(e, width, 0)), 1e-14)
            << "nu = " << nu << ", share " << share << ", strain " << e;
      }
}

TEST(MooneyRivlin, ReachesItsIncompressibleLimitLinearly) {
  for (double share : {0.0, 0.2})
    for (const auto& [name, strain] : named_strains([](double e) { return -0.5 * e; })) {
      if (strain.norm() == 0) continue;
      SCOPED_TRACE(name);
      const Response limit = MooneyRivlin{modulus, 0.5, share}(strain);
      const auto distance = [&](double below) {
        return (MooneyRivlin{modulus, 0.5 - below, share}(strain).force_eV_per_A2 - limit.force_eV_per_A2).norm();
      };
      expect_order(distance, 1e-4, 1, 1e-15);
      EXPECT_LE(distance(1e-6), 1e-5 * modulus);
    }
}

TEST(MooneyRivlin, ParametersWithoutMeaningAreRefused) {
  EXPECT_NO_THROW(neo_hookean(modulus, 0.5).check());
  EXPECT_THROW(neo_hookean(modulus, 0.51).check(), std::invalid_argument);
  EXPECT_THROW(neo_hookean(modulus, -1).check(), std::invalid_argument);
  EXPECT_THROW(neo_hookean(0, 0.3).check(), std::invalid_argument);
  EXPECT_THROW(neo_hookean(std::nan(""), 0.3).check(), std::invalid_argument);
  EXPECT_THROW((MooneyRivlin{modulus, 0.3, -0.1}.check()), std::invalid_argument);
  EXPECT_THROW((MooneyRivlin{modulus, 0.3, 1.1}.check()), std::invalid_argument);
}

}  // namespace
}  // namespace membrane::testing
