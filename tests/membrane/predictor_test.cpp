// The guess of the next equilibrium, on paths whose form is known.
#include "membrane/triangles/predictor.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace membrane {
namespace {

/// A sheet of two nodes that scales as thin sheets do: u_xy ~ d², u_z ~ d, F ~ d³; with a pretension t
/// besides.
PathPoint scaling_point(double d, double t = 0) {
  PathPoint point;
  point.conjugate_depth_A = d;
  point.force_eV_per_A = d * d * d + t * d;
  point.compliance = 1 / (3 * d * d + t);
  point.u.resize(6);
  point.u << 0.1 * d * d, -0.2 * d * d, -d, 0.05 * d * d, 0.3 * d * d, -0.4 * d;
  return point;
}

TEST(Predictor, OnePointSufficesWhereTheSheetScales) {
  Predictor predictor;
  predictor.add(scaling_point(2));
  EXPECT_LE((predictor.displacements(6) - scaling_point(6).u).norm(), 1e-14);
  EXPECT_NEAR(predictor.conjugate_depth(216), 6, 1e-13);
}

TEST(Predictor, FollowsACubicInTheDepth) {
  const auto bent = [](double d) {
    PathPoint point = scaling_point(d);
    point.u *= 1 + 0.3 * d - 0.02 * d * d + 0.01 * d * d * d;
    return point;
  };
  Predictor predictor;
  for (double d : {1.0, 2.0, 2.5, 4.0}) predictor.add(bent(d));
  EXPECT_LE((predictor.displacements(5) - bent(5).u).norm(), 1e-11);
}

TEST(Predictor, SurvivesADepthVisitedTwice) {
  Predictor predictor;
  for (double d : {1.0, 2.0, 2.0, 1.0}) predictor.add(scaling_point(d));
  EXPECT_TRUE(predictor.displacements(3).allFinite());
  EXPECT_TRUE(std::isfinite(predictor.conjugate_depth(3)));
}

TEST(Predictor, GuessesTheDepthAtAForce) {
  Predictor predictor;
  predictor.add(scaling_point(1, 5));
  predictor.add(scaling_point(1.5, 5));
  EXPECT_NEAR(predictor.conjugate_depth(scaling_point(2, 5).force_eV_per_A), 2, 0.01);
}

}  // namespace
}  // namespace membrane
