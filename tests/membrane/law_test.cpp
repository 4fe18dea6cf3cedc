// Every law on the list, relaxed and unrelaxed: derivatives, borders, objectivity, prestress.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>
#include <vector>

#include "membrane/laws/prestress.hpp"
#include "membrane/laws/tension_field.hpp"
#include "states.hpp"
#include "taylor.hpp"

namespace membrane::testing {
namespace {

const Voigt direction = Voigt(0.6, -0.35, 0.7).normalized();
constexpr double step = 4e-5;  // stays on its own side of a border

template <class Call>
void expect_derivatives(Call call, const Voigt& strain, double modulus) {
  const Response at = call(strain);
  const double noise = 1e-16 * modulus;
  expect_order(
      [&](double t) {
        return std::abs(call(strain + t * direction).energy_eV_per_A2 - at.energy_eV_per_A2 -
                        t * at.force_eV_per_A2.dot(direction));
      },
      step, 2, noise);
  expect_order(
      [&](double t) {
        return (call(strain + t * direction).force_eV_per_A2 - at.force_eV_per_A2 -
                t * at.tangent_eV_per_A2 * direction)
            .norm();
      },
      step, 2, 10 * noise);
  EXPECT_LE((at.tangent_eV_per_A2 - at.tangent_eV_per_A2.transpose()).norm(), noise * 10);
}

template <class Visit>
void over_laws_and_states(Visit visit) {
  over_laws([&](const auto& law) {
    for (const NamedStrain& state : named_strains([&](double e) { return law.natural_width(e); })) {
      SCOPED_TRACE(state.name);
      visit(law, state.strain);
    }
  });
}

TEST(Law, UnrelaxedDerivativesAreThoseOfTheEnergy) {
  over_laws_and_states(
      [](const auto& law, const Voigt& strain) { expect_derivatives(law, strain, law.sheet_modulus_eV_per_A2); });
}

TEST(Law, RelaxedDerivativesAreThoseOfTheEnergy) {
  over_laws_and_states([](const auto& law, const Voigt& strain) {
    if (strain.norm() == 0) return;  // rest is on the border of all three states: no tangent there
    expect_derivatives([&](const Voigt& e) { return tension_field(law, e); }, strain, law.sheet_modulus_eV_per_A2);
  });
}

TEST(Law, RelaxedNeverCompresses) {
  over_laws_and_states([](const auto& law, const Voigt& strain) {
    const Response at = tension_field(law, strain);
    EXPECT_GE(principal_forces(at.force_eV_per_A2).smaller, -1e-15 * law.sheet_modulus_eV_per_A2);
    EXPECT_LE(at.energy_eV_per_A2, law(strain).energy_eV_per_A2 + 1e-17);
    EXPECT_GE(at.energy_eV_per_A2, 0);
  });
}

/// Where to look for wrinkles, against the axes of the strain.
template <MaterialLaw L>
std::vector<double> turns_of_wrinkles(const L&) {
  if constexpr (IsotropicLaw<L>) return {0};
  std::vector<double> turns;
  for (int i = -60; i <= 60; ++i) turns.push_back(2.5e-3 * i);
  return turns;
}

// The relaxed energy is the least over all widths that wrinkles can hide: psi(E + w M⊗M), w ≥ 0, any M.
TEST(Law, RelaxedIsTheLeastEnergyOverWrinkles) {
  over_laws_and_states([](const auto& law, const Voigt& strain) {
    const double relaxed = tension_field(law, strain).energy_eV_per_A2;
    double least = law(strain).energy_eV_per_A2;
    const Principal at = principal_strains(strain);
    const bool slack = at.larger < 0;  // wrinkles both ways
    const double grid = slack ? 4e-3 : 1e-3;
    for (double turn : turns_of_wrinkles(law)) {
      const double angle = 0.5 * std::atan2(at.sin_2theta, at.cos_2theta) + turn;
      const Voigt across = principal_at(1, 0, angle + 0.5 * std::numbers::pi);
      const Voigt along = principal_at(1, 0, angle);
      for (int i = 0; i * grid <= 0.4; ++i)
        for (int k = 0; k * grid <= (slack ? 0.4 : 0); ++k)
          least = std::min(least, law(Voigt(strain + grid * (i * across + k * along))).energy_eV_per_A2);
    }
    EXPECT_LE(relaxed, least + 1e-17);
    EXPECT_NEAR(relaxed, least, 0.5 * 3 * law.sheet_modulus_eV_per_A2 * grid * grid);  // ½ modulus × grid²
  });
}

TEST(Law, EnergyAndForceAreContinuousOverTheBorders) {
  over_laws([](const auto& law) {
    const double jump = 1e-12;
    const auto expect_meeting = [&](const Voigt& one, const Voigt& other) {
      const Response a = tension_field(law, one);
      const Response b = tension_field(law, other);
      EXPECT_NEAR(a.energy_eV_per_A2, b.energy_eV_per_A2, 1e-11);
      EXPECT_LE((a.force_eV_per_A2 - b.force_eV_per_A2).norm(), 1e-10);
    };
    const double width = law.natural_width(0.05);
    expect_meeting(principal_at(0.05, width + jump, 0.7), principal_at(0.05, width - jump, 0.7));
    expect_meeting(principal_at(jump, -0.05, 0.7), principal_at(-jump, -0.05, 0.7));
  });
}

TEST(Law, IsTheSameFromEveryDirection) {
  over_laws_and_states([](const auto& law, const Voigt& strain) {
    const Eigen::Matrix2d turn = Eigen::Rotation2D<double>(0.83).toRotationMatrix();
    const auto tensor = [](const Voigt& v, double shear) {
      return Eigen::Matrix2d{{v[0], shear * v[2]}, {shear * v[2], v[1]}};
    };
    const Eigen::Matrix2d image = turn * tensor(strain, 0.5) * turn.transpose();
    const Response there = tension_field(turned(law, 0.83), Voigt(image(0, 0), image(1, 1), 2 * image(0, 1)));
    const Response here = tension_field(law, strain);
    EXPECT_NEAR(there.energy_eV_per_A2, here.energy_eV_per_A2, 1e-16);
    EXPECT_LE((tensor(there.force_eV_per_A2, 1) - turn * tensor(here.force_eV_per_A2, 1) * turn.transpose()).norm(),
              1e-14);
  });
}

TEST(Law, SmallStrainConstantsAreTheOnesGiven) {
  over_laws_and_states([](const auto& law, const Voigt&) {
    const Eigen::Matrix3d compliance = law(Voigt::Zero()).tangent_eV_per_A2.inverse();
    EXPECT_NEAR(1 / compliance(0, 0), law.sheet_modulus_eV_per_A2, 1e-12);
    EXPECT_NEAR(-compliance(0, 1) / compliance(0, 0), law.nu, 1e-14);
  });
}

TEST(Law, AgreesWithStVenantKirchhoffToFirstOrderInStrain) {
  over_laws([](const auto& law) {
    const StVenantKirchhoff svk{law.sheet_modulus_eV_per_A2, law.nu};
    for (const Voigt& way : {Voigt(1, 0, 0), Voigt(0.6, -0.35, 0.7), Voigt(1, 1, 0), Voigt(-1, 0.2, -1)})
      expect_order(
          [&](double t) { return (law(Voigt(t * way)).force_eV_per_A2 - svk(Voigt(t * way)).force_eV_per_A2).norm(); },
          1e-4, 2, 1e-15);
  });
}

TEST(Law, NaturalWidthLeavesNoForceAcross) {
  over_laws([](const auto& law) {
    for (double e : {1e-8, 1e-3, 0.05, 0.15}) {
      const Response at = law(Voigt(e, law.natural_width(e), 0));
      EXPECT_NEAR(at.force_eV_per_A2[1], 0, 1e-14) << e;
      if constexpr (requires { law.uniaxial(e); }) {
        const UniaxialResponse along = law.uniaxial(e);
        EXPECT_NEAR(along.force_eV_per_A2, at.force_eV_per_A2[0], 1e-14) << e;
        EXPECT_NEAR(along.energy_eV_per_A2, at.energy_eV_per_A2, 1e-15) << e;
      }
    }
  });
}

// The prestress turns with the sheet, also where its axes are not those of the strain.
TEST(Law, PrestressThatDoesNotCommuteTurnsWithTheSheet) {
  const auto image = [](const Voigt& v, double shear) {
    const Eigen::Matrix2d R = Eigen::Rotation2D<double>(0.83).toRotationMatrix();
    const Eigen::Matrix2d t = R * Eigen::Matrix2d{{v[0], shear * v[2]}, {shear * v[2], v[1]}} * R.transpose();
    return Voigt(t(0, 0), t(1, 1), t(0, 1) / shear);
  };
  const Voigt prestress(0.17592, -0.05864, 0.08796);
  over_laws_and_states([&](const auto& law, const Voigt& strain) {
    const auto force = [](const auto& of, const Voigt& e, const Voigt& p) {
      return tension_field(of, Voigt(e + offset_strain(of, p))).force_eV_per_A2;
    };
    const Voigt there = force(turned(law, 0.83), image(strain, 0.5), image(prestress, 1));
    EXPECT_LE((there - image(force(law, strain, prestress), 1)).norm(), 1e-14);
  });
}

TEST(Law, OffsetStrainCarriesThePrestress) {
  const Voigt prestress(0.17592, -0.05864, 0.08796);
  over_laws_and_states([&](const auto& law, const Voigt&) {
    EXPECT_LE((law(offset_strain(law, prestress)).force_eV_per_A2 - prestress).norm(), 1e-14);
  });
}

TEST(Law, OffsetStrainOfStVenantKirchhoffIsTheClosedForm) {
  const StVenantKirchhoff law{8.03368, 0.19};
  const Voigt p(0.17592, -0.05864, 0.08796);
  const Voigt closed =
      Voigt((p[0] - law.nu * p[1]), (p[1] - law.nu * p[0]), 2 * (1 + law.nu) * p[2]) / law.sheet_modulus_eV_per_A2;
  EXPECT_LE((offset_strain(law, p) - closed).norm(), 1e-15);
}

TEST(TensionField, WrinkledSimpleShear) {
  // gamma = 0.1: E = [0, gamma²/2, gamma/2]; S1 = 0.0525625 E·h from the larger principal strain.
  const StVenantKirchhoff law{1, 0.19};
  const Response at = tension_field(law, Voigt(0, 0.005, 0.1));
  const double larger = 0.0025 + std::sqrt(0.0025 * 0.0025 + 0.05 * 0.05);
  EXPECT_NEAR(principal_forces(at.force_eV_per_A2).larger, larger, 1e-16);
  EXPECT_NEAR(larger, 0.0525625, 1e-7);
}

}  // namespace
}  // namespace membrane::testing
