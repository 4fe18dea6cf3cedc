#include "atomistic/equilibrium/predictor.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace atomistic;
using Eigen::VectorXd;

/// u(t) with in-plane c t² and out-of-plane d t.
PathState scaling_state(double t) {
  PathState s{t, VectorXd(6)};
  s.displacement << 0.1 * t * t, -0.2 * t * t, -t, 0.3 * t * t, 0, -0.5 * t;
  return s;
}

TEST(Predictor, OneStateScalesInPlaneBySquareAndOutOfPlaneLinearly) {
  EXPECT_TRUE(extrapolate({scaling_state(2)}, 3).isApprox(scaling_state(3).displacement, 1e-14));
}

TEST(Predictor, TwoStatesGiveTheSecant) {
  const PathState a{1, VectorXd::Constant(3, 2.0)}, b{2, VectorXd::Constant(3, 5.0)};
  EXPECT_TRUE(extrapolate({a, b}, 4).isApprox(VectorXd::Constant(3, 11.0), 1e-14));
}

TEST(Predictor, ThreeStatesReproduceAParabola) {
  const std::vector<PathState> states = {scaling_state(1), scaling_state(1.5), scaling_state(3)};
  EXPECT_TRUE(extrapolate(states, 4).isApprox(scaling_state(4).displacement, 1e-13));
}

TEST(Predictor, UsesTheNewestThree) {
  std::vector<PathState> states = {
      {0.5, VectorXd::Constant(6, 99)}, scaling_state(1), scaling_state(1.5), scaling_state(3)};
  EXPECT_TRUE(extrapolate(states, 4).isApprox(scaling_state(4).displacement, 1e-13));
}

/// What is left of a minimisation, 1e-9 here, grows with the square of the steps that are extrapolated over.
TEST(Predictor, FarAheadTheNewestStateIsScaled) {
  std::vector<PathState> states = {scaling_state(1e-4), scaling_state(2e-4), scaling_state(3e-4)};
  const double left[] = {1e-9, -1e-9, 1e-9};
  for (std::size_t i = 0; i < 3; ++i) states[i].displacement.array() += left[i];
  EXPECT_LT((extrapolate(states, 0.3) - scaling_state(0.3).displacement).norm(), 5e-3);
  const VectorXd guide = VectorXd::Constant(6, 7);
  for (PathState& state : states) state.guide = VectorXd::Zero(6);
  EXPECT_TRUE(extrapolate(states, 0.3, guide).isApprox(guide, 1e-14));
  EXPECT_FALSE(extrapolate(states, 4e-4, guide).isApprox(guide, 1e-9));
}

TEST(Extrapolation, AGuideLeavesOnlyItsErrorToExtrapolate) {
  // A path of any shape, which the guide misses by something linear in t.
  const auto truth = [](double t) { return VectorXd::Constant(3, std::exp(t)); };
  const auto guide = [&](double t) { return VectorXd(truth(t).array() - 0.1 * t); };
  std::vector<PathState> states;
  EXPECT_TRUE(extrapolate(states, 2, guide(2)).isApprox(guide(2), 1e-14));
  for (const double t : {1.0, 2.0}) states.push_back({t, truth(t), guide(t)});
  EXPECT_TRUE(extrapolate(states, 4, guide(4)).isApprox(truth(4), 1e-13));
  EXPECT_FALSE(extrapolate(states, 4).isApprox(truth(4), 1e-2));
  states[0].guide.reset();
  EXPECT_TRUE(extrapolate(states, 4, guide(4)).isApprox(extrapolate(states, 4), 1e-14));
}

}  // namespace
