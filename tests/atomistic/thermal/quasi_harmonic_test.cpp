#include "atomistic/thermal/quasi_harmonic.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "atomistic/vibration.hpp"
#include "tests/atomistic/support/paths.hpp"

namespace {

using namespace atomistic;

std::vector<HeatedLevel> heated(const Problem& problem, const std::vector<Step>& steps, const Heat& heat) {
  std::vector<HeatedLevel> levels;
  heat_levels(
      problem, steps, heat, "none", {}, [&](const HeatedLevel& level) { levels.push_back(level); }, lammps_session());
  return levels;
}

/// Tersoff, R = 30 Å, a disc of 10 Å (108 atoms) under a dead force of 4 eV/Å, 300 K, the rim where it is at T = 0: a
/// quasi-harmonic code written separately finds the depth 0.0943 Å larger, Langevin dynamics of 100 ps 0.0932 ± 0.0032.
TEST(QuasiHarmonic, TersoffDiscMatchesTheReference) {
  Problem problem = problem_of("tersoff", 30, DiscLoad{10}, {1, 4});
  problem.control = Control::force;
  const Path path = follow(problem);
  ASSERT_EQ(path.steps.size(), 2u);
  const auto levels = heated(problem, {path.steps[1]}, {.temperature_K = 300});
  ASSERT_EQ(levels.size(), 1u);
  ASSERT_TRUE(levels[0].stable);
  EXPECT_NEAR(levels[0].depth_shift_A, 0.0943, 0.0005);
  EXPECT_LT(levels[0].hessian_error_relative, 1e-5);
  EXPECT_EQ(levels[0].reach_bonds, 2);
}

/// Held depth and held force differ by the depth's own vibration, ½ kT d ln(dd/dF)/dd, and by nothing else.
TEST(QuasiHarmonic, HeldDepthAndHeldForceAgree) {
  const Path path = follow(problem_of("tersoff", 20, DiscLoad{8}, {1.5, 2.94, 3, 3.06}));
  ASSERT_EQ(path.steps.size(), 4u);
  const Problem problem = problem_of("tersoff", 20, DiscLoad{8}, {1.5, 2.94, 3, 3.06});
  const auto levels = heated(problem, {path.steps[1], path.steps[2], path.steps[3]}, {.temperature_K = 300});
  const HeatedLevel& at = levels[1];
  const double depth_vibration = constants::boltzmann_eV_per_K * 300 / 2 *
                                 std::log(levels[2].compliance_A2_per_eV / levels[0].compliance_A2_per_eV) / 0.12;
  EXPECT_NEAR(at.force_shift_eV_per_A, -at.depth_shift_A / at.compliance_A2_per_eV + depth_vibration,
              2e-3 * std::abs(at.force_shift_eV_per_A));
}

/// Zero-point motion and frozen vibrations: what they change falls as 1/T².
TEST(QuasiHarmonic, QuantumStatisticsBecomeClassicalWhenHot) {
  const Problem problem = problem_of("tersoff", 15, DiscLoad{6}, {1, 2});
  const Path path = follow(problem);
  const auto shift = [&](double temperature, Statistics statistics) {
    return heated(problem, {path.steps[1]}, {.temperature_K = temperature, .statistics = statistics})[0].depth_shift_A;
  };
  const double cold = shift(300, Statistics::classical);
  EXPECT_NEAR(shift(12000, Statistics::classical), 40 * cold, 1e-5);
  EXPECT_NEAR(shift(12000, Statistics::quantum), 40 * cold, 0.01 * 40 * std::abs(cold));
  EXPECT_GT(std::abs(shift(300, Statistics::quantum) - cold), 0.3 * std::abs(cold));
}

/// A sheet that the rim compresses is no equilibrium while it is flat: said, with its mode.
TEST(QuasiHarmonic, AnUnstableSheetIsNamedWithItsMode) {
  Problem problem = problem_of("tersoff", 20, DiscLoad{8}, {0.001, 0.002});
  problem.biaxial_strain = -0.02;
  Step flat;
  flat.positions = make_sheet(problem).positions;
  flat.force_eV_per_A = flat.conjugate_depth_A = 0.001;
  const auto levels = heated(problem, {flat}, {.temperature_K = 300});
  ASSERT_EQ(levels.size(), 1u);
  EXPECT_FALSE(levels[0].stable);
  EXPECT_LT(levels[0].lowest_eigenvalue_eV_per_A2, 0);
  ASSERT_FALSE(levels[0].modes.empty());
  EXPECT_NEAR(levels[0].modes[0].out_of_plane, 1, 1e-6);
}

}  // namespace
