#include "compare/published/numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "compare/results/published.hpp"

namespace validate::published {
namespace {

Entry of(Subject quantity, double nu) {
  Entry entry;
  entry.quantity = quantity;
  entry.nu = nu;
  return entry;
}

TEST(PublishedNumbers, OfTheMembraneAreTheClosedForms) {
  EXPECT_NEAR(number_of_membrane(of(Subject::point_alpha, 1.0 / 3)), std::numbers::pi / 3, 2e-4);
  EXPECT_NEAR(number_of_membrane(of(Subject::point_beta, 1.0 / 3)), 2.0 / 3, 2e-4);
  EXPECT_NEAR(number_of_membrane(of(Subject::hencky, 0.3)), 0.653443, 1e-4);
  Entry taut = of(Subject::taut_disc, 0.165);
  taut.tip_ratio = 0.02;
  EXPECT_NEAR(number_of_membrane(taut), 2 * std::numbers::pi / (std::log(50) + 0.5), 1e-4);
}

/// A sheet whose uniaxial answer is S = 20 ε − 90 ε² + 40 ε³ exactly.
PotentialCard cubic_card() {
  PotentialCard card{.potential = {}, .card = {}, .response = {}, .lammps = {}, .law = {}, .no_law = {}};
  card.card.C11_eV_per_A2 = 20;
  card.card.C12_eV_per_A2 = 5;
  for (const char* direction : {"zigzag", "armchair", "equibiaxial"}) {
    atomistic::StressCurve curve;
    curve.direction = direction;
    for (int k = 0; k <= 20; ++k) {
      const double e = 0.01 * k, E = e + e * e / 2;
      curve.strain.push_back(e);
      curve.stress_eV_per_A2.push_back((1 + e) * (20 * E - 90 * E * E + 40 * E * E * E));
    }
    curve.strength_eV_per_A2 = 3;
    card.response.curves.push_back(curve);
  }
  return card;
}

TEST(PublishedNumbers, OfAPotentialFollowFromCardAndCurves) {
  const PotentialCard card = cubic_card();
  EXPECT_DOUBLE_EQ(number_of(card, Subject::biaxial_stiffness), 25);
  EXPECT_DOUBLE_EQ(number_of(card, Subject::poisson), 0.25);
  EXPECT_DOUBLE_EQ(number_of(card, Subject::young), (20 - 25.0 / 20) / 3.35);
  EXPECT_NEAR(number_of(card, Subject::third_zigzag), -90, 1e-6);
  EXPECT_NEAR(number_of(card, Subject::nominal_third_armchair), -90 + 1.5 * 20, 1e-6);
  EXPECT_DOUBLE_EQ(number_of(card, Subject::strength_equibiaxial), 3);
  EXPECT_THROW(number_of(card, Subject::hencky), std::logic_error);
}

TEST(PublishedRow, ZIsTheDifferenceInUncertainties) {
  PublishedRow row;
  row.ours = 437;
  row.published = 428;
  EXPECT_FALSE(z_score(row).has_value()) << "no uncertainty was published";
  row.uncertainty = 10;
  EXPECT_DOUBLE_EQ(z_score(row).value(), 0.9);
  EXPECT_FALSE(holds(row).has_value());
  row.relation = Relation::at_least;
  row.published = 0;
  EXPECT_TRUE(holds(row).value());
  row.relation = Relation::at_most;
  EXPECT_FALSE(holds(row).value());
}

}  // namespace
}  // namespace validate::published
