// Rings, quarter disc, load patterns.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "membrane/loads/pattern.hpp"
#include "membrane/sheets/grading.hpp"
#include "membrane/sheets/rectangle.hpp"
#include "membrane/sheets/rings.hpp"

namespace membrane {
namespace {

constexpr double pi = std::numbers::pi;

Mesh disc_for(double load, double record = 0, int rings = 44) {
  return make_mesh(DiscSheet{.radius_A = 110, .rings = rings}, {load, record});
}

TEST(QuarterDisc, HoldsOddNumbersOfTriangles) {
  const Mesh mesh = disc_for(0);
  EXPECT_EQ(mesh.triangles.size(), 1936u);  // the paper's 44²
  EXPECT_EQ(mesh.node_count(), 45 * 46 / 2);
  EXPECT_EQ(mesh.rim_triangles.size(), 44u);
}

TEST(QuarterDisc, LosesOnlyTheSegmentsOfItsRim) {
  const double angle = pi / 88;  // 44 chords per quarter
  const double circle = 0.25 * pi * 110 * 110;
  EXPECT_NEAR(disc_for(10).area_A2() / circle, std::sin(angle) / angle, 1e-12);
  EXPECT_NEAR(disc_for(10).area_A2() / circle, 1 - angle * angle / 6, 1e-6);
}

TEST(QuarterDisc, HoldsRimAndSymmetryPlanes) {
  const Mesh mesh = disc_for(10);
  for (int n = 0; n < mesh.node_count(); ++n) {
    const bool rim = mesh.nodes[n].norm() > 110 * (1 - 1e-12);
    EXPECT_EQ(mesh.held[n][0], rim || mesh.nodes[n].x() == 0);
    EXPECT_EQ(mesh.held[n][1], rim || mesh.nodes[n].y() == 0);
    EXPECT_EQ(mesh.held[n][2], rim);
  }
}

TEST(Grading, PutsRingsOnLoadAndRecordRadiusForAnyTip) {
  for (double load : {1e-4 * 110, 0.5, 2.2369, 10.0, 55.0, 99.0, 107.8})
    for (double record : {0.0, 1.42, 30.0})
      for (int rings : {16, 44, 72, 100}) {
        SCOPED_TRACE("load " + std::to_string(load) + " record " + std::to_string(record) + " rings " +
                     std::to_string(rings));
        const auto radii = graded_radii({110, load, record, rings});
        ASSERT_EQ(radii.size(), static_cast<std::size_t>(rings) + 1);
        EXPECT_EQ(radii.front(), 0);
        EXPECT_EQ(radii.back(), 110);
        EXPECT_TRUE(std::is_sorted(radii.begin(), radii.end(), std::less_equal<>()));
        EXPECT_EQ(std::count(radii.begin(), radii.end(), load), 1);
        EXPECT_NO_THROW(disc_mesh(radii, Extent::quarter));  // no triangle turned over
      }
}

TEST(Grading, RecordRadiusIsARingUnlessItWouldBeASliver) {
  const auto far = graded_radii({110, 10, 1.42, 72});
  EXPECT_EQ(std::count(far.begin(), far.end(), 1.42), 1);
  const auto close = graded_radii({110, 10, 10.001, 72});
  EXPECT_EQ(std::count(close.begin(), close.end(), 10.001), 0);
}

TEST(MeanOnCircle, IsExactForLinearFieldsInTheRadius) {
  const Mesh mesh = disc_for(10, 1.42);
  Eigen::VectorXd radius(mesh.node_count());
  for (int n = 0; n < mesh.node_count(); ++n) radius[n] = mesh.nodes[n].norm();
  for (double r : {0.0, 1.42, 5.03, 10.0, 109.0}) {
    const Eigen::VectorXd weights = mean_on_circle(mesh, r);
    EXPECT_NEAR(weights.sum(), 1, 1e-14);
    EXPECT_NEAR(weights.dot(radius), r, 1e-12);
  }
}

TEST(MeanOnCircle, CountsNodesOnThePlanesHalf) {
  const Mesh mesh = disc_for(10, 1.42);
  Eigen::VectorXd field(mesh.node_count());  // cos 2θ: mean 0 over the circle
  for (int n = 0; n < mesh.node_count(); ++n) {
    const Eigen::Vector2d& x = mesh.nodes[n];
    field[n] = n == 0 ? 0 : (x.x() * x.x() - x.y() * x.y()) / x.squaredNorm();
  }
  EXPECT_NEAR(mean_on_circle(mesh, 1.42).dot(field), 0, 1e-14);
}

TEST(Pattern, HasUnitTotalAndNoNegativeWeight) {
  const Mesh mesh = disc_for(10);
  for (const Pattern& pattern :
       {Pattern{mean_on_circle(mesh, 0)}, radial_pattern(mesh, 10, [](double) { return 1.0; })}) {
    EXPECT_NEAR(pattern.weights.sum(), 1, 1e-14);
    EXPECT_GE(pattern.weights.minCoeff(), 0);
  }
}

TEST(Pattern, DiscEndsAtItsEdge) {
  const Mesh mesh = disc_for(10);
  const Pattern pattern = radial_pattern(mesh, 10, [](double) { return 1.0; });
  double second_moment = 0;
  for (int n = 0; n < mesh.node_count(); ++n) {
    if (mesh.nodes[n].norm() > 10 * (1 + 1e-12)) {
      EXPECT_EQ(pattern.weights[n], 0);
    }
    second_moment += pattern.weights[n] * mesh.nodes[n].squaredNorm();
  }
  EXPECT_NEAR(second_moment, 50, 0.5);  // c²/2 of a uniform disc
}

TEST(Pattern, ConjugateDepthOfARigidShiftIsTheShift) {
  const Mesh mesh = disc_for(10);
  Eigen::VectorXd u = Eigen::VectorXd::Zero(3 * mesh.node_count());
  for (int n = 0; n < mesh.node_count(); ++n) u[3 * n + 2] = -3;
  EXPECT_NEAR(radial_pattern(mesh, 10, [](double) { return 1.0; }).direction().dot(u), 3, 1e-13);
}

TEST(Mesh, RefusesTurnedTriangles) {
  const std::vector<Eigen::Vector2d> nodes{{0, 0}, {1, 0}, {0, 1}};
  EXPECT_NO_THROW(make_triangle(nodes, {0, 1, 2}));
  EXPECT_THROW(make_triangle(nodes, {0, 2, 1}), std::invalid_argument);
  EXPECT_THROW(make_triangle(nodes, {0, 1, 1}), std::invalid_argument);
}

}  // namespace
}  // namespace membrane
