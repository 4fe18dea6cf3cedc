// Sheets under follower pressure, by its value or by the volume under them.
#include <gtest/gtest.h>

#include <cmath>

#include "compare/verify/reference_numbers.hpp"
#include "membrane/problem.hpp"
#include "solved_path.hpp"

namespace membrane {
namespace {

using testing::disc_problem;
using testing::solved_path;

double number(const char* name) { return reference::number(name).value; }

Problem pressed(double nu, Control control, std::vector<double> levels) {
  Problem problem = disc_problem(8, nu, PressureLoad{}, std::move(levels));
  problem.control = control;
  return problem;
}

TEST(PressurePath, FiniteStrainAgainstTheOneDimensionalSolver) {
  const double expected[] = {
      number("svk_pressure_height.nu_0.3.load_1e-4"), number("svk_pressure_height.nu_0.3.load_1e-3"),
      number("svk_pressure_height.nu_0.3.load_1e-2"), number("svk_pressure_height.nu_0.3.load_1e-1")};
  Problem problem = pressed(0.3, Control::force, {});
  for (double load : {1e-4, 1e-3, 1e-2, 1e-1}) problem.levels.push_back(load * 8 / 110);
  for (const Step& step : solved_path(problem)) {
    EXPECT_NEAR(step.depth_A / 110 / expected[step.level], 1, 7e-4) << step.pressure_eV_per_A3;
    EXPECT_GT(step.volume_A3, 0);
    EXPECT_EQ(step.on_triangles().smallest_pivot_sign, 1);
  }
}

TEST(PressurePath, SupportsCarryThePressureOnTheProjectedDisc) {
  const Step step = solved_path(pressed(0.3, Control::force, {1e-3})).at(0);
  const Mesh mesh = make_mesh(DiscSheet{.radius_A = 110});
  EXPECT_NEAR(step.support_force_eV_per_A.z() / (1e-3 * 4 * mesh.area_A2()), 1, 1e-7);
}

TEST(VolumePath, FindsTheStatesOfPressureControl) {
  const auto by_pressure = solved_path(pressed(0.3, Control::force, {1e-4, 1e-3, 5e-3}));
  Problem problem = pressed(0.3, Control::conjugate_depth, {});
  for (const Step& step : by_pressure) problem.levels.push_back(step.conjugate_depth_A);
  for (const Step& step : solved_path(problem)) {
    EXPECT_NEAR(step.conjugate_depth_A / problem.levels[step.level], 1, 1e-12);
    EXPECT_NEAR(step.pressure_eV_per_A3 / by_pressure[step.level].pressure_eV_per_A3, 1, 1e-7);
    EXPECT_NEAR(step.depth_A / by_pressure[step.level].depth_A, 1, 1e-7);
  }
}

TEST(VolumePath, FindsTheWrinkledSquareOfPressureControl) {
  RectangleSheet square = {.length_x_A = 220, .length_y_A = 220, .cells_x = 40, .cells_y = 40};
  Problem problem = pressed(0.19, Control::force, {5.16529e-4});
  problem.sheet = square;
  const Step by_pressure = solved_path(problem).at(0);
  problem.control = Control::conjugate_depth;
  problem.levels = {by_pressure.conjugate_depth_A};
  const Step by_volume = solved_path(problem).at(0);
  // Tucks of almost one energy differ a little: the pressure is the energy's slope in the volume.
  EXPECT_NEAR(by_volume.pressure_eV_per_A3 / 5.16529e-4, 1, 2e-3);
  EXPECT_NEAR(by_volume.energy_eV / by_pressure.energy_eV, 1, 1e-3);
}

/// A rubber sheet has a largest pressure: beyond it the volume alone can be controlled, and the pressure
/// falls while the bulge grows. dU = p dV holds on both sides.
TEST(VolumePath, GoesBeyondTheLargestPressure) {
  Problem problem = pressed(0.5, Control::conjugate_depth, {});
  problem.sheet = DiscSheet{.radius_A = 110, .rings = 24, .spacing = RingSpacing::uniform};
  problem.law = neo_hookean(8, 0.5);
  for (int i = 1; i <= 20; ++i) problem.levels.push_back(10 * i);
  const auto steps = solved_path(problem);
  const auto pressure = [&](std::size_t i) { return steps[i].pressure_eV_per_A3; };
  for (std::size_t i = 1; i < 9; ++i) EXPECT_GT(pressure(i), pressure(i - 1)) << i;
  for (std::size_t i = 10; i < steps.size(); ++i) {
    EXPECT_LT(pressure(i), pressure(i - 1)) << i;
    EXPECT_EQ(steps[i].on_triangles().smallest_pivot_sign, -1) << i;  // under a given pressure it would not stay there
  }
  for (std::size_t i = 2; i + 1 < steps.size(); ++i) {
    const Step &before = steps[i - 1], &after = steps[i + 1];
    const double slope = (after.energy_eV - before.energy_eV) / (after.volume_A3 - before.volume_A3);
    const double curved = (pressure(i + 1) - 2 * pressure(i) + pressure(i - 1)) / 6;  // Simpson's rule for the work
    EXPECT_NEAR(slope / (pressure(i) + curved), 1, 2e-3) << i;
  }
}

/// The same in one dimension, as far as a given pressure goes.
TEST(VolumePath, RubberIsThatOfTheRoundSheet) {
  Problem round;
  round.discretisation = Meridian{};
  round.sheet = DiscSheet{110};
  round.law = neo_hookean(8, 0.5);
  round.load = PressureLoad{};
  round.control = Control::force;
  round.levels = {1e-3, 1e-2, 3e-2, 4e-2};
  double depth = 0;
  const auto report = solve(round, [&](const Step& step) {
    depth = step.depth_A;
    return true;
  });
  ASSERT_TRUE(report.converged) << report.reason;
  Problem problem = pressed(0.5, Control::force, {1e-2, 3e-2, 4e-2});
  problem.sheet = DiscSheet{.radius_A = 110, .rings = 64, .spacing = RingSpacing::uniform};
  problem.law = neo_hookean(8, 0.5);  // 0.10 % too shallow with 48 rings, by the square of their width
  const Step by_pressure = solved_path(problem).back();
  EXPECT_NEAR(by_pressure.depth_A / depth, 1, 1e-3);
  problem.control = Control::conjugate_depth;
  problem.levels = {0.5 * by_pressure.conjugate_depth_A, by_pressure.conjugate_depth_A};
  const Step by_volume = solved_path(problem).back();
  EXPECT_NEAR(by_volume.pressure_eV_per_A3 / 4e-2, 1, 1e-7);
  EXPECT_NEAR(by_volume.depth_A / by_pressure.depth_A, 1, 1e-7);
}

}  // namespace
}  // namespace membrane
