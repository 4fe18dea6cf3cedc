#include "compare/results/result.hpp"

#include <gtest/gtest.h>

#include <limits>

using namespace validate;

TEST(Result, UsablePointsConvergedOutsideTheArtefactZoneWithFiniteNumbers) {
  validate::Run run;
  run.depth_A = {0, 1, 2, 3, 4, 5};
  run.force_eV_per_A = {0, 1, std::numeric_limits<double>::quiet_NaN(), 3, 4, 5};
  run.converged = {true, true, true, false, true, true};
  EXPECT_EQ(usable_points(run), (std::vector<std::size_t>{1, 4, 5}));
  EXPECT_FALSE(first_artefact(run));
  run.model = Model::atomistic;
  settle_part(run);
  run.atoms().artefact = {false, false, false, false, false, true};
  EXPECT_EQ(usable_points(run), (std::vector<std::size_t>{1, 4}));
  EXPECT_EQ(first_artefact(run), 5u);
}
