#include "atomistic/equilibrium/guide.hpp"

#include <algorithm>
#include <cmath>

namespace atomistic {

using Eigen::VectorXd;

namespace {

/// Values at 0, h, 2h, … as a cubic through the four around a place (Catmull–Rom); zero from the last one on. `parity`
/// continues them beyond the axis: 1 even, −1 odd.
double interpolated(const std::vector<double>& values, double spacing, double radius, double parity) {
  const double place = radius / spacing;
  const auto i = static_cast<std::ptrdiff_t>(place);
  const auto count = static_cast<std::ptrdiff_t>(values.size());
  if (i >= count - 1) return 0;
  const auto at = [&](std::ptrdiff_t k) {
    if (k < 0) return parity * values[static_cast<std::size_t>(-k)];
    return values[static_cast<std::size_t>(std::min(k, count - 1))];
  };
  const double t = place - static_cast<double>(i);
  const double a = at(i - 1), b = at(i), c = at(i + 1), d = at(i + 2);
  return b + 0.5 * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
}

}  // namespace

std::optional<VectorXd> guided_displacement(const Problem& problem, const Sheet& sheet, double level) {
  const auto guide = std::ranges::find_if(
      problem.guides, [&](const Guide& g) { return std::abs(g.level - level) <= 1e-12 * std::abs(level); });
  if (guide == problem.guides.end() || guide->depth_A.size() < 2) return std::nullopt;
  VectorXd u(3 * static_cast<Eigen::Index>(sheet.free_atoms));
  for (int i = 0; i < sheet.free_atoms; ++i) {
    const Eigen::Vector3d place = sheet.position(i);
    const double radius = place.head<2>().norm();
    const double outward = interpolated(guide->outward_A, guide->spacing_A, radius, -1);
    u.segment<2>(3 * i) = radius > 0 ? Eigen::Vector2d(place.head<2>() * (outward / radius)) : Eigen::Vector2d::Zero();
    u[3 * i + 2] = -interpolated(guide->depth_A, guide->spacing_A, radius, 1);
  }
  return u;
}

}  // namespace atomistic
