// Eqs. 2 and 12 of Gil et al. 2010 are misprinted (4 and 13 too, law_spatial_test.cpp): corrected, the code;
// printed, not.
#include <gtest/gtest.h>

#include <cmath>

#include "membrane/laws/prestress.hpp"
#include "membrane/laws/st_venant_kirchhoff.hpp"
#include "membrane/laws/tension_field.hpp"

namespace membrane {
namespace {

constexpr double E = 5.864;
constexpr double nu = 0.19;
const StVenantKirchhoff law{E, nu};

double green(double lambda) { return 0.5 * (lambda * lambda - 1); }

TEST(Misprint, Equation2) {
  // Plane stress: λ̄ = 2 λ μ / (λ + 2 μ).
  const double lame = E * nu / ((1 + nu) * (1 - 2 * nu));
  const double mu = E / (2 * (1 + nu));
  const double bar = 2 * lame * mu / (lame + 2 * mu);
  const auto energy = [](double l1, double l2) { return law(Voigt(green(l1), green(l2), 0)).energy_eV_per_A2; };
  const auto corrected = [&](double l1, double l2) {
    const double a = l1 * l1 - 1;
    const double b = l2 * l2 - 1;
    return bar / 8 * (a + b) * (a + b) + mu / 4 * (a * a + b * b);
  };
  const auto printed = [&](double l1, double l2) {
    const double a = l1 * l1 - 1;
    const double b = l2 * l2 - 1;
    return bar / 4 * (a + b) + mu / 4 * a * b;
  };
  for (double l1 : {1.0, 1.02, 1.1})
    for (double l2 : {0.97, 1.0, 1.05}) EXPECT_NEAR(energy(l1, l2), corrected(l1, l2), 1e-14);
  // The printed one pulls on the unstretched sheet: dψ/dλ1 = λ̄/2 at rest, where there is no stress.
  const double h = 1e-6;
  EXPECT_NEAR((corrected(1 + h, 1) - corrected(1 - h, 1)) / (2 * h), 0, 1e-9);
  EXPECT_NEAR((printed(1 + h, 1) - printed(1 - h, 1)) / (2 * h), bar / 2, 1e-9);
}

TEST(Misprint, Equation12) {
  // S1 of a wrinkled sheet = E (λ1² − 1)/2 + n1·σp n1 − ν n2·σp n2; printed with + ν.
  const double s1 = 0.12;
  const double s2 = 0.05;
  const Voigt offset = offset_strain(law, Voigt(s1, s2, 0));
  const auto relaxed = [&](double l1, double l2) {
    return tension_field(law, Voigt(Voigt(green(l1), green(l2), 0) + offset));
  };
  const double l1 = 1.05;
  const double l2 = 0.9;
  ASSERT_EQ(sheet_state(law, principal_strains(Voigt(Voigt(green(l1), green(l2), 0) + offset))), SheetState::wrinkled);
  const double corrected = E * green(l1) + s1 - nu * s2;
  const double printed = E * green(l1) + s1 + nu * s2;
  const double h = 1e-4;  // S1 = dψ/dE1 = (dψ/dλ1)/λ1
  const double difference =
      (relaxed(l1 + h, l2).energy_eV_per_A2 - relaxed(l1 - h, l2).energy_eV_per_A2) / (2 * h) / l1;
  EXPECT_NEAR(difference, corrected, 1e-7);
  EXPECT_NEAR(relaxed(l1, l2).force_eV_per_A2[0], corrected, 1e-14);
  EXPECT_NEAR(relaxed(l1, l2).force_eV_per_A2[0] - printed, -2 * nu * s2, 1e-14);

  // And Eq. 15, slack where S1 = 0, needs the minus too.
  const double slack = std::sqrt(1 - 2 * (s1 - nu * s2) / E);
  EXPECT_GT(relaxed(slack + 1e-6, 0.8).energy_eV_per_A2, 0);
  EXPECT_EQ(relaxed(slack - 1e-6, 0.8).energy_eV_per_A2, 0);
}

}  // namespace
}  // namespace membrane
