#include "atomistic/cell/response.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "atomistic/cell/homogeneous_cell.hpp"
#include "tests/atomistic/support/paths.hpp"

namespace {

using namespace atomistic;

class ResponseOf : public testing::TestWithParam<std::string> {};

/// Small uniaxial strain answers with the card's E·h and ν, equibiaxial with C11 + C12; the knot of AIREBO's spline
/// bends its curves at the start.
TEST_P(ResponseOf, StartsWithTheCardsModuli) {
  const Card& card = card_of(GetParam());
  const StrainState strains[] = {{1e-4, -1e-4 * card.nu(), 0, 0}, {1e-4, 1e-4, 0, 0}};
  const Response r = compute_response(potential(GetParam()), card, {strains[0], strains[1]}, "none");
  EXPECT_NEAR(r.states[0].S11_eV_per_A2 / 1e-4, card.sheet_modulus_eV_per_A2(), 0.01 * card.sheet_modulus_eV_per_A2());
  EXPECT_NEAR(r.states[0].S22_eV_per_A2 / 1e-4, 0, 0.01 * card.sheet_modulus_eV_per_A2());
  const double biaxial = card.C11_eV_per_A2 + card.C12_eV_per_A2;
  EXPECT_NEAR(r.states[1].S11_eV_per_A2 / 1e-4, biaxial, 0.01 * biaxial);
  ASSERT_EQ(r.curves.size(), 3u);
  for (const StressCurve& c : r.curves) {
    EXPECT_GT(c.strength_eV_per_A2, 1);
    EXPECT_GT(c.strain_at_strength, 0.1);
    EXPECT_GE(c.strain.size(), 10u);
  }
  EXPECT_NEAR(r.curves[0].lateral_strain[1] / r.curves[0].strain[1], -card.nu(), 0.08);
}

/// S is the derivative of the energy per reference area: by the order of the central difference's error.
TEST_P(ResponseOf, StressIsTheEnergysDerivative) {
  const auto along = [](double h) { return StrainState{0.05 + h, 0.02 - 0.5 * h, 0.01 + 0.3 * h, 15}; };
  std::vector<StrainState> strains;
  for (double h : {0.0, 4e-3, -4e-3, 2e-3, -2e-3}) strains.push_back(along(h));
  const auto s = compute_response(potential(GetParam()), card_of(GetParam()), strains, "none").states;
  for (const HomogeneousState& state : s) EXPECT_TRUE(state.converged);
  const double slope = s[0].S11_eV_per_A2 - 0.5 * s[0].S22_eV_per_A2 + 2 * 0.3 * s[0].S12_eV_per_A2;
  const double coarse = (s[1].energy_eV_per_A2 - s[2].energy_eV_per_A2) / 8e-3 - slope;
  const double fine = (s[3].energy_eV_per_A2 - s[4].energy_eV_per_A2) / 4e-3 - slope;
  EXPECT_LT(std::abs(fine), 2e-4 * std::abs(slope));
  EXPECT_LT(std::abs(fine), 0.35 * std::abs(coarse) + 1e-6 * std::abs(slope));
}

INSTANTIATE_TEST_SUITE_P(Shipped, ResponseOf, testing::ValuesIn(shipped_potentials()), test_name);

/// Turning a strain by 60° changes nothing; by 90° exchanges zigzag and armchair.
TEST(Response, HasTheLatticesSymmetry) {
  const StrainState plain{0.08, 0.01, 0, 0}, sixty{0.08, 0.01, 0, 60}, ninety{0.08, 0.01, 0, 90},
      across{0.01, 0.08, 0, 0};
  const auto s =
      compute_response(potential("airebo"), card_of("airebo"), {plain, sixty, ninety, across}, "none").states;
  EXPECT_NEAR(s[1].S11_eV_per_A2, s[0].S11_eV_per_A2, 1e-7);
  EXPECT_NEAR(s[1].energy_eV_per_A2, s[0].energy_eV_per_A2, 1e-9);
  EXPECT_NEAR(s[2].S11_eV_per_A2, s[3].S22_eV_per_A2, 1e-7);
  EXPECT_GT(std::abs(s[2].S11_eV_per_A2 - s[0].S11_eV_per_A2), 0.01);
}

/// Equal strains keep the sublattices in balance by symmetry, long after the lattice has lost its hold in it.
TEST(Response, ABalanceThatIsNoMinimumDoesNotCountAsAState) {
  const auto s =
      compute_response(potential("tersoff"), card_of("tersoff"), {{0.1, 0.1, 0, 0}, {0.4, 0.4, 0, 0}}, "none").states;
  EXPECT_TRUE(s[0].converged);
  EXPECT_FALSE(s[1].converged);
  EXPECT_NEAR(s[1].shift_x_A, 0, 1e-9);
  EXPECT_NEAR(s[1].S11_eV_per_A2, s[1].S22_eV_per_A2, 1e-6);
}

TEST(Response, RefusesAStrainWithoutDeformation) {
  EXPECT_THROW(compute_response(potential("tersoff"), card_of("tersoff"), {{-0.6, 0, 0, 0}}, "none"),
               std::invalid_argument);
}

}  // namespace
