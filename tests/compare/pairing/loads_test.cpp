// Every load that a case can name, as each model knows it.
#include "compare/pairing/loads.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/compare/pairing/sample_material.hpp"

using namespace validate;

namespace {

Case of_load(LoadKind load) {
  Case c;
  c.radius_A = 20;
  c.tip_radius_A = 5;
  c.loads = {load};
  c.pressures_eV_per_A3 = {1e-3};
  return c;
}

class Loads : public testing::TestWithParam<std::string_view> {
 protected:
  LoadKind load() const { return *from_word<LoadKind>(GetParam()); }
};

/// A load without its answer throws where it is paired.
TEST_P(Loads, HasItsAnswersOfAtomsAndMembrane) {
  const Case c = of_load(load());
  ASSERT_NO_THROW(check(c));
  ASSERT_NO_THROW(atoms_load(c, load()));
  ASSERT_NO_THROW(nominal_load(c, load()));
  const sample::Pairing pairing(c);
  ASSERT_NO_THROW(twin_of(c, pairing.sheet(), load()));
}

/// Both models press in the same way: where the one follows forces, the other does.
TEST_P(Loads, IsPairedWithItsTwin) {
  const Case c = of_load(load());
  sample::Pairing pairing(c);
  const PairedLoad& pair = pairing.loads().at(0);
  ASSERT_TRUE(pair.atoms);
  const ContinuumExperiment* twin = pair.find(Purpose::like_for_like);
  ASSERT_TRUE(twin);
  EXPECT_EQ(pair.atoms->problem.control == atomistic::Control::force,
            twin->problem.control == membrane::Control::force);
  EXPECT_EQ(twin->problem.load.index(), twin_of(c, pairing.sheet(), load()).index());
  if (std::isnan(pair.atoms->run.tip_A))
    EXPECT_TRUE(std::isnan(twin->run.tip_A));
  else
    EXPECT_EQ(pair.atoms->run.tip_A, twin->run.tip_A);
}

INSTANTIATE_TEST_SUITE_P(All, Loads, testing::ValuesIn(all_words<LoadKind>),
                         [](const auto& test) { return std::string(test.param); });

TEST(TipRadius, IsThatOfTheDiscOrTheSphereAndNothingElse) {
  EXPECT_EQ(tip_radius_A(membrane::PointLoad{}), 0);
  EXPECT_EQ(tip_radius_A(membrane::DiscLoad{7}), 7);
  EXPECT_EQ(tip_radius_A(membrane::SphereLoad{9}), 9);
  EXPECT_EQ(tip_radius_A(membrane::RadialLoad{{1, 3}, {1, 0}}), 3);
  EXPECT_TRUE(std::isnan(tip_radius_A(membrane::PressureLoad{})));
  EXPECT_TRUE(std::isnan(tip_radius_A(membrane::EdgeMotion{})));
}

}  // namespace
