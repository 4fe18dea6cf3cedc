// The rigid frictionless sphere.
#include "reference/svk_sphere.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "reference/convergence.hpp"
#include "reference/shallow_tip.hpp"
#include "reference/svk_disc.hpp"

namespace reference {
namespace {

// Lee, Wei, Kysar, Hone, Science 321 (2008) 385: tips of 16.5 and 27.5 nm on graphene (nm, N/m, nN).
const SvkSheet graphene{342, 0.165, 0.34};

TEST(SvkSphere, TouchesLaplacesParaboloidWhileShallow) {
  const double N0 = 1e-3;
  const auto excess = [&](double b) {
    const SvkSphereState state = svk_sphere_at_contact({{1, 0.165, N0}, 1, 0.5}, b);
    const ShallowSphere limit = shallow_sphere(0.5, b);
    return std::pair{state.force / (N0 * limit.force) - 1, state.depth / limit.depth - 1};
  };
  const auto [force, depth] = excess(1e-3);
  const auto [force_finer, depth_finer] = excess(1e-4);
  EXPECT_LT(std::abs(force_finer), 1e-5);
  EXPECT_LT(std::abs(depth_finer), 1e-5);
  EXPECT_NEAR(force / force_finer, 100, 1);   // stretching adds a share of b²
  EXPECT_NEAR(depth / depth_finer, 100, 10);  // with a logarithm of b
}

TEST(SvkSphere, DoesAsMuchWorkAsItStores) {
  const SvkSphere sphere{graphene, 500, 16.5};
  const double force = svk_sphere_at_depth(sphere, 50).force;
  const auto remainder = [&](double step) {
    const double more = svk_sphere_at_depth(sphere, 50 + step).energy;
    return (more - svk_sphere_at_depth(sphere, 50 - step).energy) / (2 * step * force) - 1;
  };
  EXPECT_LT(std::abs(remainder(0.5)), 1e-4);
  EXPECT_NEAR(remainder(1) / remainder(0.5), 4, 0.05);
}

TEST(SvkSphere, PressesEverywhereItTouches) {
  for (const double depth : {5.0, 100.0})
    EXPECT_GT(svk_sphere_at_depth({graphene, 500, 27.5}, depth).least_pressure, 0);
}

// A tip that pulls no more on the far sheet than its force: a disc and a sphere leave the same rim behind.
TEST(SvkSphere, LeavesTheFarSheetToTheForce) {
  const SvkSphereState sphere = svk_sphere_at_depth({graphene, 500, 5}, 60);
  const SvkDiscState disc = svk_disc_at_force({graphene, 500, sphere.contact_radius}, sphere.force);
  EXPECT_NEAR(sphere.rim_force / disc.rim_force, 1, 2e-3);
}

TEST(SvkSphere, IsStifferTheLargerItIs) {
  double last = 0;
  for (const double tip_radius : {5.0, 16.5, 27.5}) {
    const double force = svk_sphere_at_depth({graphene, 500, tip_radius}, 50).force;
    EXPECT_GT(force, last);
    last = force;
  }
}

TEST(SvkSphere, Converges) {
  const auto depth = [](int steps) { return svk_sphere_at_contact({graphene, 500, 16.5}, 7, steps).depth; };
  testing::expect_converges(depth, 6, 6, 1e-12);
  testing::expect_settled(depth, 48, 1e-10);
}

}  // namespace
}  // namespace reference
