// The clamped disc at finite strain.
#include "reference/svk_disc.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "reference/convergence.hpp"
#include "reference/foppl_disc.hpp"
#include "reference/foppl_point.hpp"
#include "reference/shallow_tip.hpp"

namespace reference {
namespace {

using std::numbers::pi;

const SvkDisc case2{{5.864 * 1.37, 0.19}, 110, 10};  // Gil et al. 2010, figure 2: Å, eV
const SvkDisc of_record{{8.03368, 0.19, 0.02}, 110, 11};
const SvkDisc figure1{{342, 0.165, 0.34}, 500, 16.5};  // Gil et al. 2010, figure 1: nm, N/m, nN

// Depth and force computed with a code written separately (tests/membrane/data/case2_disc10.csv).
TEST(SvkDisc, AgreesWithTheTableOfCase2) {
  constexpr std::array<std::array<double, 2>, 6> table{
      {{10, 0.897970298}, {20, 7.1922863}, {30, 24.3123123}, {40, 57.7243462}, {50, 112.91528}, {60, 195.376672}}};
  for (const auto& [depth, force] : table)
    EXPECT_NEAR(svk_disc_at_force(case2, force).centre_depth / depth, 1, 2e-9) << depth;
  EXPECT_NEAR(svk_disc_at_depth(case2, 30).force, 24.3123123, 1e-7);
}

// Figures of Gil et al. 2010 as solved elsewhere, to the digits given there.
TEST(SvkDisc, AgreesWithDepthsComputedElsewhere) {
  EXPECT_NEAR(svk_disc_at_force(case2, 20).centre_depth, 28.113, 5e-4);
  EXPECT_NEAR(svk_disc_at_force(of_record, 20).centre_depth, 27.1628, 1e-4);
  EXPECT_NEAR(svk_disc_at_force(figure1, 1500).centre_depth, 97.58, 5e-3);
  SvkDisc small_tip = figure1;
  small_tip.load_radius = 1e-4 * figure1.radius;
  EXPECT_NEAR(svk_disc_at_force(small_tip, 1500).centre_depth, 103.37, 5e-3);
  SvkDisc point = case2;
  point.load_radius = 1e-7 * case2.radius;
  EXPECT_NEAR(svk_disc_at_force(point, 20).centre_depth, 31.62, 5e-3);
}

// u = 0, w = delta (1 − (r/a)^(2/3)) solves the finite problem for nu = 1/3, so that F = π/3 E·h delta³/a²
// holds at any depth; the small disc is the only difference.
TEST(SvkDisc, IsSchwerinsSolutionAtAnyDepthForOneThird) {
  for (const double depth : {0.01, 0.1, 0.3}) {
    const auto excess = [depth](double c) {
      return svk_disc_at_depth({{1, 1.0 / 3}, 1, c}, depth).force / (pi / 3 * depth * depth * depth) - 1;
    };
    const double coarse = excess(8e-7), fine = excess(1e-7);
    EXPECT_LT(std::abs(fine), 5e-5) << depth;
    EXPECT_NEAR(coarse / fine, 4, 0.3) << depth;  // (c/a)^(2/3), its factor changing with the slope at the tip
  }
}

TEST(SvkDisc, IsFopplsMembraneAtSmallDepth) {
  const FopplDepth foppl = foppl_disc({0.19, 10.0 / 110}, 1);
  const auto alpha_excess = [&](double depth) {
    const double force = svk_disc_at_depth({{1, 0.19}, 1, 10.0 / 110}, depth).force;
    return force / (depth * depth * depth) * foppl.centre * foppl.centre * foppl.centre - 1;
  };
  EXPECT_LT(std::abs(alpha_excess(0.02)), 1e-4);
  EXPECT_NEAR(alpha_excess(0.04) / alpha_excess(0.02), 4, 0.1);  // of second order in the depth
  const SvkDiscState state = svk_disc_at_depth({{1, 0.19}, 1, 10.0 / 110}, 0.004);
  EXPECT_NEAR(state.rim_force / (0.004 * 0.004), foppl.rim_force / (foppl.centre * foppl.centre), 1e-5);
  EXPECT_NEAR(state.conjugate_depth / state.centre_depth, foppl.conjugate / foppl.centre, 1e-5);
}

TEST(SvkDisc, FollowsTheLogarithmWhileShallow) {
  for (const double c : {0.02, 1.0 / 11}) {
    const SvkDiscState state = svk_disc_at_force({{1, 0.19, 0.01}, 1, c}, 1e-7);
    EXPECT_NEAR(state.force / (0.01 * state.centre_depth) / shallow_disc_stiffness(c), 1, 1e-5);
    EXPECT_NEAR(state.force / (0.01 * state.conjugate_depth) / shallow_disc_conjugate_stiffness(c), 1, 1e-5);
    EXPECT_NEAR(state.rim_force, 0.01, 1e-7);
  }
}

TEST(SvkDisc, DoesAsMuchWorkAsItStores) {
  const auto remainder = [](double step) {
    const SvkDiscState less = svk_disc_at_force(of_record, 20 - step), more = svk_disc_at_force(of_record, 20 + step);
    return (more.energy - less.energy) / (more.conjugate_depth - less.conjugate_depth) / 20 - 1;
  };
  EXPECT_LT(std::abs(remainder(0.5)), 1e-3);
  EXPECT_NEAR(remainder(1) / remainder(0.5), 4, 0.05);
}

TEST(SvkDisc, IsTautForPositiveNuSoThatWrinklesChangeNothing) {
  SvkDisc relaxed = case2;
  relaxed.sheet.wrinkles = true;
  EXPECT_NEAR(svk_disc_at_force(relaxed, 20).centre_depth, svk_disc_at_force(case2, 20).centre_depth, 1e-11);
  relaxed.sheet.nu = -0.158;  // compressed along the hoop near the rim
  SvkDisc unrelaxed = relaxed;
  unrelaxed.sheet.wrinkles = false;
  EXPECT_GT(svk_disc_at_force(relaxed, 20).centre_depth, svk_disc_at_force(unrelaxed, 20).centre_depth * (1 + 1e-6));
}

TEST(SvkDisc, Converges) {
  const auto depth = [](int steps) { return svk_disc_at_force(of_record, 20, steps).centre_depth; };
  testing::expect_converges(depth, 8, 6, 1e-12);
  testing::expect_settled(depth, 48, 1e-10);
}

}  // namespace
}  // namespace reference
