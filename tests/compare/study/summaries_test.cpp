// What a card says of a strength that the potential's cut-off makes.
#include "compare/study/summaries.hpp"

#include <gtest/gtest.h>

#include "compare/base/units.hpp"
#include "compare/documents/texts/card_files.hpp"

using namespace validate;

namespace {

/// Stress rises by 1 eV/Å² per 10 % of strain to `strongest` eV/Å²; the artefact length is reached at `artefact`.
atomistic::StressCurve curve(double strongest, std::optional<double> artefact) {
  atomistic::StressCurve c;
  c.direction = "zigzag";
  for (int k = 0; k <= static_cast<int>(10 * strongest); ++k) {
    c.strain.push_back(0.01 * k);
    c.lateral_strain.push_back(0);
    c.stress_eV_per_A2.push_back(0.1 * k);
    c.longest_bond_A.push_back(1.4 + 0.014 * k);
  }
  c.strength_eV_per_A2 = strongest;
  c.strain_at_strength = 0.1 * strongest;
  c.artefact_strain = artefact;
  return c;
}

Result card_with(const atomistic::StressCurve& c) {
  PotentialCard card{.potential = {}, .card = {}, .response = {}, .lammps = {}, .law = {}, .no_law = {}};
  card.response.curves = {c};
  return potential_result(card);
}

TEST(Strength, BeyondTheArtefactLengthIsMarkedAndBounded) {
  const Result result = card_with(curve(6, 0.255));
  const StressCurve& c = result.stress_curves.at(0);
  EXPECT_TRUE(c.strength_is_artefact);
  ASSERT_TRUE(c.largest_before_artefact_eV_per_A2);
  EXPECT_NEAR(*c.largest_before_artefact_eV_per_A2, 2.5, 1e-12);
  const std::string text = card_table(result);  // 2.5 and 6 eV/Å² are 40.05 and 96.13 N/m
  EXPECT_NE(text.find("≥ 40.1 (cut-off's: 96.1)"), std::string::npos) << text;
}

TEST(Strength, WithinTheArtefactLengthIsTheValueItself) {
  for (const std::optional<double> artefact : {std::optional(0.65), std::optional<double>()}) {
    const Result result = card_with(curve(6, artefact));
    EXPECT_FALSE(result.stress_curves.at(0).strength_is_artefact);
    EXPECT_EQ(result.stress_curves[0].largest_before_artefact_eV_per_A2.has_value(), artefact.has_value());
    EXPECT_NE(card_table(result).find(" 96.1 "), std::string::npos) << card_table(result);
    EXPECT_EQ(card_table(result).find("cut-off's"), std::string::npos);
  }
}

/// A stress that fell before the artefact length was reached had its largest value before.
TEST(Strength, TheBoundIsTheLargestStressBefore) {
  atomistic::StressCurve c = curve(6, 0.255);
  c.stress_eV_per_A2[12] = 3.3;
  EXPECT_DOUBLE_EQ(*card_with(c).stress_curves.at(0).largest_before_artefact_eV_per_A2, 3.3);
}

}  // namespace
