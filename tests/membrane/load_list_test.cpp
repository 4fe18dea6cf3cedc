// The list of loads: what one must answer, and that every one of them acts.
#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "membrane/problem.hpp"

namespace membrane {
namespace {

/// A load that nobody checks, and one of which nobody knows how it acts.
struct Unchecked {
  CentreForce action() const { return {}; }
};
struct Idle {
  void check(const LoadSetting&) const {}
};
static_assert(LoadKind<PointLoad> && !LoadKind<Unchecked> && !LoadKind<Idle>);

/// How a load acts, by its place in Action.
std::size_t way_of(const Load& load) { return action_of(load).index(); }

TEST(LoadList, EveryWayToActHasALoad) {
  const std::set<std::size_t> ways = {way_of(PointLoad{}), way_of(DiscLoad{3}), way_of(SphereLoad{3}),
                                      way_of(PressureLoad{}), way_of(EdgeMotion{})};
  EXPECT_EQ(ways.size(), std::variant_size_v<Action>);
}

TEST(LoadList, DensitiesAreLinearBetweenTheirPairs) {
  const auto spread = std::get<SpreadForce>(action_of(RadialLoad{{1, 3, 5}, {2, 4, 0}}));
  EXPECT_EQ(spread.radius_A, 5);
  EXPECT_EQ(spread.density(0.5), 2);
  EXPECT_EQ(spread.density(2), 3);
  EXPECT_EQ(spread.density(4), 2);
  EXPECT_EQ(spread.density(5), 0);
}

// One load, two discretisations: what either can bear is its own.
TEST(LoadList, WidestLoadsDependOnTheDiscretisation) {
  Problem problem;
  problem.sheet = DiscSheet{.radius_A = 100};
  problem.law = StVenantKirchhoff{8, 0.2};
  problem.levels = {1};
  for (const Load& load : {Load(DiscLoad{99}), Load(SphereLoad{150})}) {
    problem.load = load;
    problem.discretisation = Triangles{};
    EXPECT_THROW(check(problem), std::invalid_argument);
    problem.discretisation = Meridian{};
    EXPECT_NO_THROW(check(problem));
  }
}

}  // namespace
}  // namespace membrane
