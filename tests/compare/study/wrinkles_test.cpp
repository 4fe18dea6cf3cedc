// Wrinkles around the axis: their number, length and height from points of a sheet.
#include "compare/study/wrinkles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace validate {
namespace {

constexpr double radius_A = 100;

/// Points all over the disc at a depth that is round but for waves which are highest at 0.8 of the radius.
std::vector<SheetPoint> wavy(int count, double amplitude_A) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<SheetPoint> points;
  for (int i = 0; i < 20000; ++i) {
    const double s = std::sqrt(uniform(random)), angle = 2 * std::numbers::pi * uniform(random);
    const double waves = amplitude_A * std::exp(-50 * (s - 0.8) * (s - 0.8)) * std::cos(count * angle + 0.3);
    points.push_back({radius_A * s * Eigen::Vector2d(std::cos(angle), std::sin(angle)), 20 * (1 - s) + waves});
  }
  return points;
}

TEST(Wrinkles, AreCountedAndMeasured) {
  for (const int count : {5, 12, 31}) {
    const Wrinkles found = wrinkles_of(wavy(count, 2), radius_A);
    EXPECT_EQ(found.count, count);
    EXPECT_NEAR(found.amplitude_A, 2, 0.15);
    EXPECT_NEAR(found.wavelength_A, 2 * std::numbers::pi * 0.8 * radius_A / count, 0.05 * found.wavelength_A);
  }
}

TEST(Wrinkles, ARoundSheetHasNone) { EXPECT_EQ(wrinkles_of(wavy(12, 0), radius_A).count, 0); }

// A quarter's waves are those of the whole: its nodes are mirrored, those on the planes once.
TEST(Wrinkles, AQuarterIsMirrored) {
  membrane::Problem problem;
  problem.sheet = membrane::DiscSheet{.radius_A = radius_A, .rings = 40, .spacing = membrane::RingSpacing::uniform};
  problem.load = membrane::DiscLoad{10};
  const membrane::Mesh mesh = membrane::mesh_of(problem);
  membrane::TriangleShape shape;
  shape.displacements = Eigen::VectorXd::Zero(3 * mesh.node_count());
  for (int n = 0; n < mesh.node_count(); ++n) {
    const Eigen::Vector2d place = mesh.nodes[static_cast<std::size_t>(n)];
    const double s = place.norm() / radius_A;
    shape.displacements[3 * n + 2] = -s * (1 - s) * 4 * std::cos(8 * std::atan2(place.y(), place.x()));
  }
  const auto points = points_of(mesh, shape);
  EXPECT_EQ(points.size(), 1u + 4 * 40 * 41 / 2);  // ring i of the whole has 4 i nodes
  const Wrinkles found = wrinkles_of(points, radius_A);
  EXPECT_EQ(found.count, 8);
  EXPECT_NEAR(found.amplitude_A, 1, 0.02);
}

}  // namespace
}  // namespace validate
