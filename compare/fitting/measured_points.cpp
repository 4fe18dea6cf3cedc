#include "compare/fitting/measured_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "compare/base/errors.hpp"
#include "compare/base/units.hpp"
#include "compare/results/fit.hpp"

namespace validate {
namespace {

/// Fewer points do not tell noise in depth from noise in force.
constexpr std::size_t points_for_depth_noise = 40;

double baseline(const MeasuredCurve& curve, double to_A) {
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < curve.depth_A.size(); ++i) {
    if (!(curve.depth_A[i] <= to_A)) continue;
    sum += curve.force_eV_per_A[i];
    ++count;
  }
  if (count == 0)
    throw bad_input("--baseline: {} has no point at a depth of {:g} Å or less", curve.file.string(), to_A);
  return sum / count;
}

/// The points inside the window with the given zeros taken off, and the σ columns of the file with them.
struct Selected {
  CurvePoints points;
  std::vector<double> sigma_force, sigma_depth;
};

Selected select_points(const MeasuredCurve& curve, const MeasuredOptions& options, double zero_eV_per_A) {
  Selected s;
  for (std::size_t i = 0; i < curve.depth_A.size(); ++i) {
    const double depth = curve.depth_A[i] - options.contact_A;
    if (options.depth_min_A && depth < *options.depth_min_A) continue;
    if (options.depth_max_A && depth > *options.depth_max_A) continue;
    s.points.depth_A.push_back(depth);
    s.points.force_eV_per_A.push_back(curve.force_eV_per_A[i] - zero_eV_per_A);
    if (!curve.sigma_eV_per_A.empty()) s.sigma_force.push_back(curve.sigma_eV_per_A[i]);
    if (!curve.sigma_depth_A.empty()) s.sigma_depth.push_back(curve.sigma_depth_A[i]);
  }
  if (s.points.depth_A.size() < fewest_points_to_fit)
    throw bad_input("{}: {} of {} points are inside the window; a fit needs {}", curve.file.string(),
                    s.points.depth_A.size(), curve.depth_A.size(), fewest_points_to_fit);
  return s;
}

/// A force that falls with the depth has the wrong sign, or is a whole cycle of approach and retraction.
void check_sign(const CurvePoints& points, const std::string& file) {
  const auto [low, high] = std::ranges::minmax(points.force_eV_per_A);
  const auto deepest = std::ranges::max_element(points.depth_A) - points.depth_A.begin();
  const double at_the_end = points.force_eV_per_A[static_cast<std::size_t>(deepest)];
  if (!(at_the_end - low > 0.5 * (high - low)))
    throw bad_input(
        "{}: the force does not grow with the depth (at the deepest point it is {:.4g} nN, between {:.4g} and {:.4g} "
        "nN): is its sign turned, or are approach and retraction in one file?",
        file, at_the_end * nN_per_eV_per_A, low * nN_per_eV_per_A, high * nN_per_eV_per_A);
  if (std::ranges::max(points.depth_A) <= 0)
    throw bad_input("{}: no point is beyond the contact; are sign and zero of the depth right?", file);
}

/// What is known of the noise; the rest is estimated.
Noise noise_of(const Selected& s, const MeasuredOptions& options, const std::string& file) {
  Noise noise;
  Weighting weighting = options.weighting;
  if (weighting == Weighting::automatic)
    weighting = s.sigma_force.empty() || options.sigma_force_eV_per_A ? Weighting::uniform : Weighting::sigma;
  if (weighting == Weighting::sigma) {
    if (s.sigma_force.empty())
      throw bad_input("--weights sigma: {} has no column sigma; add one or choose it with --sigma-column", file);
    noise.force_weight = s.sigma_force;
    noise.force_eV_per_A = 1;
  } else if (weighting == Weighting::relative) {
    // A force that happens to be near zero must not outweigh all others.
    const double floor = 0.01 * std::ranges::max(s.points.force_eV_per_A);
    for (const double f : s.points.force_eV_per_A) noise.force_weight.push_back(std::max(std::abs(f), floor));
  } else {
    noise.force_eV_per_A = options.sigma_force_eV_per_A;
  }
  noise.depth_A = options.sigma_depth_A;
  if (!noise.depth_A && !s.sigma_depth.empty()) {
    double sum = 0;
    for (const double sigma : s.sigma_depth) sum += sigma * sigma;
    noise.depth_A = std::sqrt(sum / static_cast<double>(s.sigma_depth.size()));
  }
  const bool told_apart = s.points.depth_A.size() >= points_for_depth_noise && weighting == Weighting::uniform;
  if (!noise.depth_A && !told_apart) noise.depth_A = 0;
  return noise;
}

/// A height of the cantilever's base less its deflection.
MeasuredCurve with_depths(MeasuredCurve curve, const MeasuredOptions& options) {
  if (!curve.depth_from_height) return curve;
  if (!options.spring_constant_eV_per_A2)
    throw bad_input("--spring-constant: is needed, since {} has heights ({}) and no depths: depth = z − F/k",
                    curve.file.string(), curve.depth_column);
  for (std::size_t i = 0; i < curve.depth_A.size(); ++i)
    curve.depth_A[i] -= curve.force_eV_per_A[i] / *options.spring_constant_eV_per_A2;
  return curve;
}

}  // namespace

CurvePoints measured_points(const MeasuredCurve& measured, const MeasuredOptions& options, double& baseline_eV_per_A) {
  const MeasuredCurve curve = with_depths(measured, options);
  const std::string file = curve.file.string();
  baseline_eV_per_A = options.baseline_to_A ? baseline(curve, *options.baseline_to_A) : 0;
  Selected selected = select_points(curve, options, baseline_eV_per_A);
  check_sign(selected.points, file);
  selected.points.noise = noise_of(selected, options, file);
  if (curve.depth_from_height) selected.points.compliance_A2_per_eV = 1 / *options.spring_constant_eV_per_A2;
  return std::move(selected.points);
}

}  // namespace validate
