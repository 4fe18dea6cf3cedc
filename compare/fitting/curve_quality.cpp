#include "compare/fitting/curve_quality.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "compare/base/units.hpp"

namespace validate {
namespace {

/// Least squares of a parabola over x from −1 to 1: its bend, and the standard error of that.
struct Bend {
  double value = 0, error = 0;
};

Bend bend_of(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<Eigen::Index>(x.size());
  const auto [low, high] = std::ranges::minmax(x);
  Eigen::MatrixXd columns(n, 3);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double t = 2 * (x[static_cast<std::size_t>(i)] - low) / (high - low) - 1;
    columns.row(i) << 1, t, t * t;
  }
  const Eigen::Map<const Eigen::VectorXd> values(y.data(), n);
  const Eigen::Matrix3d normal = columns.transpose() * columns;
  const Eigen::Vector3d p = normal.ldlt().solve(columns.transpose() * values);
  const double variance = (values - columns * p).squaredNorm() / static_cast<double>(n - 3);
  return {p[2], std::sqrt(variance * normal.inverse()(2, 2))};
}

/// Of the deepest tenth of the points: how much the force grows with the height.
double last_slope(const std::vector<double>& z, const std::vector<double>& force) {
  const std::size_t n = z.size(), few = std::max<std::size_t>(n / 10, 5), from = n - few;
  double mz = 0, mf = 0, zz = 0, zf = 0;
  for (std::size_t i = from; i < n; ++i)
    mz += z[i] / static_cast<double>(few), mf += force[i] / static_cast<double>(few);
  for (std::size_t i = from; i < n; ++i) zz += (z[i] - mz) * (z[i] - mz), zf += (z[i] - mz) * (force[i] - mf);
  return zf / zz;
}

}  // namespace

std::string looks_wrong(const MeasuredCurve& curve, const std::optional<double>& stiffness) {
  constexpr std::size_t fewest = 20;
  if (!curve.preparation || curve.depth_A.size() < fewest) return {};
  const CurvePreparation& p = *curve.preparation;
  const auto &z = curve.depth_A, &force = curve.force_eV_per_A;
  if (p.baseline_points == 0) return "no contact: the curve has no ten points before it";
  constexpr double rigid = 0.97;
  if (curve.depth_from_height && stiffness)
    if (const double share = last_slope(z, force) / *stiffness; share > rigid)
      return fmt::format("substrate: at its end {:.0f} % of the way is deflection, no sheet gives so little",
                         100 * share);
  const double largest = std::ranges::max(force), sudden = std::max(8 * p.noise_eV_per_A, 0.03 * largest);
  for (std::size_t i = 1; i < z.size(); ++i)
    if (z[i - 1] > 0 && force[i - 1] - force[i] > sudden)
      return fmt::format("slip or break: the force falls by {:.3g} nN at {:.4g} nN",
                         nN_per_eV_per_A * (force[i - 1] - force[i]), nN_per_eV_per_A * force[i - 1]);
  std::vector<double> before_z, before_force;
  constexpr double margin = 0.05;  // of the way before the contact
  for (std::size_t i = 0; i < z.size() && z[i] < margin * z.front(); ++i) {
    before_z.push_back(z[i]);
    before_force.push_back(force[i]);
  }
  if (before_z.size() < fewest || p.baseline != Baseline::tilt) return {};
  const Bend bend = bend_of(before_z, before_force);
  // A parabola through the baseline would be this far off at the deepest point.
  const double half = (before_z.back() - before_z.front()) / 2, middle = (before_z.back() + before_z.front()) / 2;
  const double off = std::abs(bend.value) * std::pow((z.back() - middle) / half, 2);
  constexpr double certain = 6, matters = 0.01;
  if (std::abs(bend.value) > certain * bend.error && off > matters * largest)
    return fmt::format("drift: the baseline is bent by {:.3g} nN", nN_per_eV_per_A * std::abs(bend.value));
  return {};
}

}  // namespace validate
