#include "compare/study/wrinkles.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace validate {
namespace {

constexpr double innermost = 0.3, width = 0.05;  // of the radius
constexpr int fewest = 3, most = 80;             // waves around; fewer are the sheet's tilt and the clamp's shape
constexpr double noise_A = 0.05;                 // a lattice of atoms is not round by a little less

/// Depths of one ring without its round part, which is a parabola over so narrow a ring.
struct Ring {
  double radius_A = 0;
  std::vector<double> angle, height_A;

  std::complex<double> wave(int count) const {
    std::complex<double> sum = 0;
    for (std::size_t i = 0; i < angle.size(); ++i) sum += height_A[i] * std::polar(1.0, -count * angle[i]);
    return 2.0 / static_cast<double>(angle.size()) * sum;
  }
};

Ring ring_of(const std::vector<SheetPoint>& points, double from_A, double to_A) {
  Ring ring{.radius_A = (from_A + to_A) / 2, .angle = {}, .height_A = {}};
  std::vector<double> place;
  for (const SheetPoint& point : points) {
    const double r = point.flat_A.norm();
    if (r < from_A || r >= to_A) continue;
    ring.angle.push_back(std::atan2(point.flat_A.y(), point.flat_A.x()));
    ring.height_A.push_back(point.depth_A);
    place.push_back((r - ring.radius_A) / (to_A - from_A));
  }
  const auto count = static_cast<Eigen::Index>(place.size());
  if (count < 4) return ring;
  const Eigen::Map<const Eigen::VectorXd> t(place.data(), count);
  Eigen::MatrixXd powers(count, 3);
  powers << Eigen::VectorXd::Ones(count), t, t.cwiseAbs2();
  Eigen::Map<Eigen::VectorXd> height(ring.height_A.data(), count);
  height -= powers * powers.colPivHouseholderQr().solve(Eigen::VectorXd(height));
  return ring;
}

}  // namespace

std::vector<SheetPoint> points_of(const atomistic::Sheet& sheet, const Eigen::VectorXd& positions) {
  std::vector<SheetPoint> points;
  for (int i = 0; i < sheet.free_atoms; ++i) points.push_back({sheet.position(i).head<2>(), -positions[3 * i + 2]});
  return points;
}

/// Nodes on a symmetry plane are their own image.
std::vector<SheetPoint> points_of(const membrane::Mesh& mesh, const membrane::TriangleShape& shape) {
  std::vector<SheetPoint> points;
  for (int n = 0; n < mesh.node_count(); ++n) {
    const Eigen::Vector2d place = mesh.nodes[static_cast<std::size_t>(n)];
    const double depth = -shape.displacements[3 * n + 2];
    for (const double x : {1.0, -1.0})
      for (const double y : {1.0, -1.0}) {
        if ((x < 0 && (!mesh.mirrored[0] || place.x() == 0)) || (y < 0 && (!mesh.mirrored[1] || place.y() == 0)))
          continue;
        points.push_back({{x * place.x(), y * place.y()}, depth});
      }
  }
  return points;
}

Wrinkles wrinkles_of(const std::vector<SheetPoint>& points, double radius_A) {
  std::vector<Ring> rings;
  for (double from = innermost; from < 1 - 1e-9; from += width)
    rings.push_back(ring_of(points, from * radius_A, (from + width) * radius_A));
  Wrinkles found;
  double strongest = 0;
  for (int count = fewest; count <= most; ++count) {
    double power = 0, highest = 0, at = 0;
    for (const Ring& ring : rings) {
      if (ring.angle.size() < static_cast<std::size_t>(4 * count)) continue;
      const double amplitude = std::abs(ring.wave(count));
      power += amplitude * amplitude * ring.radius_A;
      if (amplitude > highest) highest = amplitude, at = ring.radius_A;
    }
    if (!(power > strongest)) continue;
    strongest = power;
    found = {count, 2 * std::numbers::pi * at / count, highest};
  }
  if (found.amplitude_A < noise_A) return {0, 0, found.amplitude_A};
  return found;
}

}  // namespace validate
