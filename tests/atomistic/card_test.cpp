#include "atomistic/card.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <ostream>

#include "tests/atomistic/lammps_session.hpp"

namespace {

using namespace atomistic;

/// Computed with LAMMPS 29 Sep 2021 by programs written separately from this project: lattice constant from the zero of
/// the membrane force, moduli by strained cells, bending modulus of a rippled strip of 120 Å.
struct Reference {
  double a0_A, Eh_N_per_m, nu, bending_modulus_eV;
};
const std::map<std::string, Reference> references = {{"airebo", {2.41924328, 277.7, 0.3645, 0.966}},
                                                     {"rebo", {2.46018783, 244.0, 0.3945, 1.401}},
                                                     {"tersoff", {2.49204894, 354.9, 0.065, 1.865}},
                                                     {"tersoff-1989", {2.5298, 407.3, -0.158, 1.02}},
                                                     {"lcbop", {2.45931935, 315.0, 0.2215, 0.730}}};

class CardOf : public testing::TestWithParam<std::string> {};

TEST_P(CardOf, MatchesTheReference) {
  ASSERT_TRUE(references.contains(GetParam())) << "a new potential needs a reference here";
  const Reference& expected = references.at(GetParam());
  const Card card = compute_card(potential(GetParam()), "none");
  EXPECT_NEAR(card.a0_A, expected.a0_A, 4e-5);  // the reference of tersoff-1989 has four decimals
  EXPECT_NEAR(card.sheet_modulus_eV_per_A2() * 16.02176634, expected.Eh_N_per_m, 0.005 * expected.Eh_N_per_m);
  EXPECT_NEAR(card.nu(), expected.nu, 0.005 * std::abs(expected.nu));
  EXPECT_NEAR(card.bending_modulus_eV(), expected.bending_modulus_eV, 0.01 * expected.bending_modulus_eV);
}

/// A hexagonal sheet is isotropic to first order. The angular spline of AIREBO and REBO has a knot at 120°, so that
/// their response at any finite strain is not quite linear: C66 differs by 0.7 %.
TEST_P(CardOf, IsIsotropic) {
  const Card card = compute_card(potential(GetParam()), "none");
  const double isotropic = (card.C11_eV_per_A2 - card.C12_eV_per_A2) / 2;
  EXPECT_NEAR(card.C66_eV_per_A2, isotropic, 0.01 * isotropic);
  EXPECT_NEAR(card.bending_modulus_zigzag_eV, card.bending_modulus_armchair_eV, 1e-3 * card.bending_modulus_eV());
}

INSTANTIATE_TEST_SUITE_P(Shipped, CardOf, testing::ValuesIn(shipped_potentials()), test_name);

}  // namespace
