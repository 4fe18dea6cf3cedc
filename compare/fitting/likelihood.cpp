#include "compare/fitting/likelihood.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "compare/fitting/cantilever.hpp"

namespace validate {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int most_parameters = 16;

CurvePoints selected(const CurvePoints& points, const std::vector<std::size_t>& which) {
  CurvePoints some;
  some.noise = points.noise;
  some.compliance_A2_per_eV = points.compliance_A2_per_eV;
  some.noise.force_weight.clear();
  for (const std::size_t i : which) {
    some.depth_A.push_back(points.depth_A[i]);
    some.force_eV_per_A.push_back(points.force_eV_per_A[i]);
    if (!points.noise.force_weight.empty()) some.noise.force_weight.push_back(points.noise.force_weight[i]);
  }
  return some;
}

/// Sheets of one E·h and pretension: the model, and one for each input.
struct Likelihood::Sheets {
  ForceCurve plain;
  std::vector<ForceCurve> larger;
};

/// Of one point: how far it is from the curve, seen along its errors, with the derivatives over θ.
struct Likelihood::Local {
  using Row = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_parameters, 1>;  ///< without allocation
  double miss = 0, variance = 0, log_variance = 0;
  double slope = 0, bend = 0;  ///< what take_slopes holds
  double left = 0;             ///< variance of its place along the curve, once the miss is known
  Row mean_by;                 ///< of the curve as the point sees it: −∂(miss), the variance held
  Row slope_by;                ///< of the curve's slope there
  Row variance_by, log_by;     ///< of the variance with the slope held: where it is seen, and as ln v has it
};

Likelihood::Likelihood(CurvePoints points, ForceModel model, FreeZeros free, std::vector<UncertainInput> inputs)
    : points_(std::move(points)), model_(std::move(model)), inputs_(std::move(inputs)) {
  if (free.contact) contact_ = count_++;
  if (free.force_zero) force_zero_ = count_++;
  if (free.slope) slope_ = count_++;
  first_input_ = count_;
  count_ += static_cast<int>(inputs_.size());
  if (!points_.noise.force_eV_per_A) force_noise_ = count_++;
  if (!points_.noise.depth_A) depth_noise_ = count_++;
  along_ = points_.depth_A;
  for (std::size_t i = 0; i < along_.size(); ++i) along_[i] += points_.compliance_A2_per_eV * points_.force_eV_per_A[i];
  const auto [least, most] = std::ranges::minmax(along_);
  deepest_ = most - least;
  // What no point is known better than: else a curve without noise would be infinitely likely.
  rounding_ =
      1e-8 * std::abs(*std::ranges::max_element(points_.force_eV_per_A, {}, [](double f) { return std::abs(f); }));
  const double typical = deepest_ / static_cast<double>(std::max<std::size_t>(along_.size() - 1, 1));
  contact_width_ = std::max(points_.noise.depth_A.value_or(0), typical / 2);
}

namespace {

/// How deep a point is in the mean where its contact is uncertain by `width`: smooth, 0 far before the contact.
struct SoftDepth {
  double value, first, second;  ///< of the depth, and its derivatives over it
};

SoftDepth soft_depth(double depth, double width) {
  constexpr double far = 8;  // widths: all is then 1e-15 from what it is without a width
  if (!(std::abs(depth) < far * width)) return {std::max(depth, 0.0), depth > 0 ? 1.0 : 0.0, 0};
  const double t = depth / width, density = std::exp(-t * t / 2) / std::sqrt(2 * std::numbers::pi),
               share = std::erfc(-t / std::numbers::sqrt2) / 2;
  return {depth * share + width * density, share, density / width};
}

}  // namespace

/// Mean force at a depth below the contact, and its derivatives over the depth and, at a place of the file, over θ.
struct Likelihood::Mean {
  double force = 0, slope = 0, curvature = 0;
  double bend = 0;  ///< curvature of the sheet's force alone: the contact's blur is in the mean already
  Local::Row by, slope_by;
};

Likelihood::Sheets Likelihood::sheets(const VectorXd& theta) const {
  const auto seen = [&](const ForceModel& model) {
    ForceCurve curve = curve_of(model, theta[0], theta[1]);
    const double compliance = points_.compliance_A2_per_eV;
    return compliance > 0 ? in_series(std::move(curve), compliance) : curve;
  };
  Sheets s{seen(model_), {}};
  for (const UncertainInput& input : inputs_) s.larger.push_back(seen(input.larger));
  return s;
}

namespace {

/// In proportion to the depth where it is almost none.
ForceAlong near_contact(const ForceCurve& curve, double depth, double least) {
  if (depth >= least) return curve(depth);
  const ForceAlong at = curve(least);
  const auto times = [](const ForceAt& f, double factor) {
    return ForceAt{factor * f.force, factor * f.by_Eh, factor * f.by_pretension};
  };
  return {times(at.value, depth / least), times(at.value, 1 / least), 0};
}

}  // namespace

Likelihood::Mean Likelihood::mean(double depth, const VectorXd& theta, const Sheets& sheets) const {
  const SoftDepth soft = soft_depth(depth, contact_ >= 0 ? contact_width_ : 0);
  Mean m;
  m.by = m.slope_by = Local::Row::Zero(count_);
  if (soft.value > 0) {
    const auto sheet = [&](const ForceCurve& curve) { return near_contact(curve, soft.value, 1e-6 * deepest_); };
    const ForceAlong s = sheet(sheets.plain);
    m.by[0] = s.value.by_Eh;
    m.by[1] = s.value.by_pretension;
    m.slope_by[0] = soft.first * s.first.by_Eh;
    m.slope_by[1] = soft.first * s.first.by_pretension;
    ForceAlong sum = s;
    for (std::size_t k = 0; k < inputs_.size(); ++k) {
      const int at = first_input_ + static_cast<int>(k);
      const ForceAlong larger = sheet(sheets.larger[k]);
      const double z = theta[at];
      m.by[at] = larger.value.force - s.value.force;
      m.by[0] += z * (larger.value.by_Eh - s.value.by_Eh);
      m.by[1] += z * (larger.value.by_pretension - s.value.by_pretension);
      m.slope_by[at] = soft.first * (larger.first.force - s.first.force);
      m.slope_by[0] += soft.first * z * (larger.first.by_Eh - s.first.by_Eh);
      m.slope_by[1] += soft.first * z * (larger.first.by_pretension - s.first.by_pretension);
      sum.value.force += z * m.by[at];
      sum.first.force += z * (larger.first.force - s.first.force);
      sum.second += z * (larger.second - s.second);
    }
    m.force = sum.value.force;
    m.slope = soft.first * sum.first.force;
    m.bend = soft.first * soft.first * sum.second;
    m.curvature = m.bend + soft.second * sum.first.force;
  }
  if (slope_ >= 0) {
    m.force += theta[slope_] * depth;
    m.slope += theta[slope_];
    m.by[slope_] = depth;
    m.slope_by[slope_] = 1;
  }
  if (contact_ >= 0) {
    m.by[contact_] = -m.slope;
    m.slope_by[contact_] = -m.curvature;
  }
  if (force_zero_ >= 0) {
    m.force += theta[force_zero_];
    m.by[force_zero_] = 1;
  }
  return m;
}

namespace {

/// Of a point's errors, seen from a curve of a slope there.
struct Errors {
  double force2, depth2, rounding2;

  double variance(double slope) const { return force2 + slope * slope * depth2 + rounding2; }
  /// Error of the depth that goes with a miss of the force, per miss: half of −d ln v/d slope.
  double share(double slope) const { return -slope * depth2 / variance(slope); }
  double share_by_slope(double slope) const {
    const double s = share(slope);
    return 2 * s * s - depth2 / variance(slope);
  }
  /// Variance of the depth that is left when the miss is known.
  double left(double slope) const {
    const double s = share(slope);
    return std::max(depth2 - s * s * variance(slope), 0.0);
  }
  /// Derivatives over σ_F² and σ_d².
  std::array<double, 2> variance_by(double slope) const { return {1, slope * slope}; }
  std::array<double, 2> share_by(double slope) const {
    const double s = share(slope), all = variance(slope);
    return {-s / all, (-slope - s * slope * slope) / all};
  }
};

}  // namespace

Likelihood::Local Likelihood::local(std::size_t i, const VectorXd& theta, const Sheets& sheets) const {
  const Noise& noise = points_.noise;
  const double weight = noise.force_weight.empty() ? 1 : noise.force_weight[i];
  const double force2 = force_noise_ >= 0 ? theta[force_noise_] : std::pow(*noise.force_eV_per_A, 2);
  const Errors errors{weight * weight * force2,
                      depth_noise_ >= 0 ? theta[depth_noise_] : *noise.depth_A * *noise.depth_A, rounding_ * rounding_};
  const std::array<double, 2> by_theta = {weight * weight, 1};  // over θ itself: σ_F² and σ_d²
  const std::array<int, 2> noises = {force_noise_, depth_noise_};
  const double depth = along_[i] - (contact_ >= 0 ? theta[contact_] : 0);
  // The curve stands for its mean over the errors of the depth, which its bend raises.
  const double force = points_.force_eV_per_A[i] + (bends_.empty() ? 0 : bends_[i]);

  // The place on the curve that the errors make most likely, by one projection, and how it moves.
  Mean m = mean(depth, theta, sheets);
  double likely = depth;
  Local::Row likely_by = Local::Row::Zero(count_);
  if (errors.depth2 > 0) {
    const double away = force - m.force, share = errors.share(m.slope);
    likely -= share * away;
    likely_by = share * m.by - away * errors.share_by_slope(m.slope) * m.slope_by;
    const auto share_by = errors.share_by(m.slope);
    for (std::size_t k = 0; k < 2; ++k)
      if (noises[k] >= 0) likely_by[noises[k]] -= away * share_by[k] * by_theta[k];
    m = mean(likely, theta, sheets);
  }
  Local l;
  l.variance = errors.variance(m.slope);
  l.miss = force - m.force - m.slope * (depth - likely);
  // What the projection has left to do; were it exact, the place and the slope would not count.
  const double rest = depth - likely - errors.share(m.slope) * l.miss;
  l.mean_by = m.by + rest * (m.slope_by + m.curvature * likely_by);
  l.slope = m.slope;
  l.left = errors.left(m.slope);
  l.slope_by = m.slope_by;
  l.bend = 0.5 * m.bend * l.left;
  const double seen = slopes_.empty() ? m.slope : slopes_[i];
  l.log_variance = std::log(errors.variance(seen));
  l.variance_by = l.log_by = Local::Row::Zero(count_);
  const auto here = errors.variance_by(m.slope), held = errors.variance_by(seen);
  for (std::size_t k = 0; k < 2; ++k) {
    if (noises[k] < 0) continue;
    l.variance_by[noises[k]] = here[k] * by_theta[k];
    l.log_by[noises[k]] = held[k] * by_theta[k] / errors.variance(seen);
  }
  return l;
}

void Likelihood::take_slopes(const VectorXd& theta) {
  const Sheets all = sheets(theta);
  std::vector<double> slopes, bends;
  for (std::size_t i = 0; i < points_.depth_A.size(); ++i) {
    const Local l = local(i, theta, all);
    slopes.push_back(l.slope);
    bends.push_back(l.bend);
  }
  slopes_ = std::move(slopes);
  bends_ = std::move(bends);
}

Likelihood::At Likelihood::at(const VectorXd& theta) const {
  At sum;
  sum.minus_two_log = std::numeric_limits<double>::infinity();
  if (!(theta[0] > 0) || (force_noise_ >= 0 && !(theta[force_noise_] >= 0)) ||
      (depth_noise_ >= 0 && !(theta[depth_noise_] >= 0)))
    return sum;
  double total = 0;
  sum.gradient = VectorXd::Zero(count_);
  sum.information = MatrixXd::Zero(count_, count_);
  sum.excess = MatrixXd::Zero(count_, count_);
  const Sheets all = sheets(theta);
  for (std::size_t i = 0; i < points_.depth_A.size(); ++i) {
    const Local l = local(i, theta, all);
    if (!(l.variance > 0)) return sum;
    const double scaled = l.miss / l.variance;
    total += l.miss * scaled + l.log_variance;
    sum.gradient += -2 * scaled * l.mean_by - scaled * scaled * l.variance_by + l.log_by;
    const double by_mean = 2 / l.variance;
    for (int row = 0; row < count_; ++row)
      for (int column = 0; column <= row; ++column) {
        sum.information(row, column) += by_mean * l.mean_by[row] * l.mean_by[column] + l.log_by[row] * l.log_by[column];
        sum.excess(row, column) += by_mean * l.left * l.slope_by[row] * l.slope_by[column];
      }
  }
  for (std::size_t k = 0; k < inputs_.size(); ++k) {
    const int z = first_input_ + static_cast<int>(k);
    total += theta[z] * theta[z];
    sum.gradient[z] += 2 * theta[z];
    sum.information(z, z) += 2;
  }
  if (!std::isfinite(total)) return sum;
  sum.minus_two_log = total;
  sum.information = MatrixXd(sum.information.selfadjointView<Eigen::Lower>());
  sum.excess = MatrixXd(sum.excess.selfadjointView<Eigen::Lower>());
  return sum;
}

Likelihood::Prediction Likelihood::prediction(const VectorXd& theta) const {
  Prediction p;
  const Sheets all = sheets(theta);
  for (std::size_t i = 0; i < points_.depth_A.size(); ++i) {
    const Local l = local(i, theta, all);
    p.miss.push_back(l.miss);
    p.sigma.push_back(std::sqrt(l.variance));
  }
  return p;
}

double Likelihood::contact_depth(const VectorXd& theta) const {
  const double zero = force_zero_ >= 0 ? theta[force_zero_] : 0;
  return contact_ >= 0 ? theta[contact_] - points_.compliance_A2_per_eV * zero : 0;
}

VectorXd Likelihood::start() const {
  constexpr int contacts = 40;
  const auto& d = points_.depth_A;
  const auto n = static_cast<Eigen::Index>(d.size());
  const double low = std::ranges::min(d), high = std::ranges::max(d);
  const Eigen::Map<const VectorXd> force(points_.force_eV_per_A.data(), n);
  VectorXd best = VectorXd::Zero(count_);
  double least = std::numeric_limits<double>::infinity();
  for (int trial = 0; trial < (contact_ >= 0 ? contacts : 1); ++trial) {
    const double contact = contact_ >= 0 ? low - 0.1 * (high - low) + 0.8 * (high - low) * trial / contacts : 0;
    // The cubic's and the line's coefficient from the model at the deepest point.
    const double deepest = high - contact;
    if (!(deepest > 0)) break;
    const ForceAt untensioned = model_.at(deepest, model_.typical_Eh, 0);
    const double cubic = untensioned.force / (model_.typical_Eh * deepest * deepest * deepest);
    const double line = untensioned.by_pretension;
    MatrixXd columns(n, 2 + (force_zero_ >= 0) + (slope_ >= 0));
    for (Eigen::Index i = 0; i < n; ++i) {
      const double x = d[static_cast<std::size_t>(i)] - contact, inside = std::max(x, 0.0);
      columns(i, 0) = cubic * inside * inside * inside;
      columns(i, 1) = line * inside;
      if (force_zero_ >= 0) columns(i, 2) = 1;
      if (slope_ >= 0) columns(i, columns.cols() - 1) = x;
    }
    const VectorXd p = columns.colPivHouseholderQr().solve(force);
    const double sum = (columns * p - force).squaredNorm();
    if (!(p[0] > 0) || !(sum < least)) continue;
    least = sum;
    best[0] = p[0];
    best[1] = p[1];
    if (force_zero_ >= 0) best[force_zero_] = p[2];
    if (contact_ >= 0)
      best[contact_] = contact + (force_zero_ >= 0 ? points_.compliance_A2_per_eV * best[force_zero_] : 0);
    if (slope_ >= 0) best[slope_] = p[columns.cols() - 1];
  }
  if (!std::isfinite(least)) {
    const auto deepest = std::ranges::max_element(d) - d.begin();
    best[0] = model_.typical_Eh * std::abs(force[deepest]) / model_.at(high, model_.typical_Eh, 0).force;
    least = force.squaredNorm();
  }
  if (force_noise_ >= 0) best[force_noise_] = least / static_cast<double>(n);
  if (depth_noise_ >= 0) best[depth_noise_] = std::pow(1e-3 * (high - low), 2);
  return best;
}

}  // namespace validate
