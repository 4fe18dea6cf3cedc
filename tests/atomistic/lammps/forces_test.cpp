#include "atomistic/lammps/forces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "atomistic/lattice/sheet.hpp"
#include "tests/atomistic/support/lammps_session.hpp"

namespace {

using namespace atomistic;
using Eigen::VectorXd;

/// Every state as if it were the only one, whatever has been asked for before.
TEST(Forces, OfEachStateAreThoseOfAFreshField) {
  const Sheet sheet = make_sheet(8, 2.46, 0, 3);
  VectorXd rippled = sheet.positions;
  for (int i = 0; i < sheet.atoms(); ++i) rippled[3 * i + 2] = 0.3 * std::sin(1.3 * i);
  const auto states =
      compute_forces(potential("rebo"), {sheet.positions, rippled, 1.01 * rippled}, "none", lammps_session());
  ASSERT_EQ(states.size(), 3u);
  ForceField field(potential("rebo"), {.low = {-40, -40, -40}, .high = {40, 40, 40}}, rippled, "none");
  VectorXd forces;
  EXPECT_NEAR(field.evaluate(rippled, forces), states[1].energy_eV, 1e-9);
  EXPECT_LT((forces - states[1].forces_eV_per_A).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_GT(states[1].energy_eV, states[0].energy_eV);
}

TEST(Forces, RefusesWhatIsNoSetOfStates) {
  EXPECT_THROW(compute_forces(potential("rebo"), {}, "none", lammps_session()), std::invalid_argument);
  EXPECT_THROW(compute_forces(potential("rebo"), {VectorXd::Zero(6), VectorXd::Zero(9)}, "none", lammps_session()),
               std::invalid_argument);
  EXPECT_THROW(compute_forces(potential("rebo"), {VectorXd::Zero(4)}, "none", lammps_session()), std::invalid_argument);
}

}  // namespace
