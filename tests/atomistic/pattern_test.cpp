#include "atomistic/loads/pattern.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace {

using namespace atomistic;

TEST(LoadPattern, WeightsAreNotNegativeAndSumToOneAlongZ) {
  const Sheet sheet = make_sheet(20, 2.46, 0, 5);
  for (const Load& load : {Load(PointLoad{}), Load(DiscLoad{8})}) {
    const LoadPattern pattern(load, sheet);
    EXPECT_NEAR(pattern.direction().sum(), 1.0, 1e-13);
    EXPECT_GE(pattern.direction().minCoeff(), 0.0);
    for (Eigen::Index i = 0; i < pattern.direction().size(); ++i)
      EXPECT_TRUE(i % 3 == 2 || pattern.direction()[i] == 0.0);
  }
}

TEST(LoadPattern, ConjugateDepthIsTheMeanDepthOfTheLoadedAtoms) {
  const Sheet sheet = make_sheet(20, 2.46, 0, 5);
  const LoadPattern pattern(DiscLoad{6}, sheet);
  Eigen::VectorXd x = sheet.positions.head(3 * sheet.free_atoms);
  double mean = 0;
  for (int atom : atoms_within(sheet, 6)) {
    x[3 * atom + 2] = -0.1 * atom;
    mean += 0.1 * atom / static_cast<double>(pattern.atoms().size());
  }
  EXPECT_NEAR(pattern.conjugate_depth(x), mean, 1e-12 * mean);
}

TEST(LoadPattern, RefusesADiscThatHoldsNothingOrTheClamp) {
  const Sheet sheet = make_sheet(20, 2.46, 0, 5);
  EXPECT_THROW(LoadPattern(DiscLoad{0.5}, sheet), std::invalid_argument);
  EXPECT_THROW(LoadPattern(DiscLoad{22}, sheet), std::invalid_argument);
}

}  // namespace
