#include "compare/fitting/inference.hpp"

#include <fmt/core.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "compare/base/units.hpp"
#include "compare/fitting/normal.hpp"

namespace validate {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double confidence = 0.95;
constexpr double nm_per_A = 0.1;

/// Standard errors of E·h and σ0·h from the points' noise alone, and from each input alone.
std::vector<ErrorSource> sources(const Likelihood& likelihood, const LikelihoodMaximum& best, double numerical) {
  std::vector<int> own;  // parameters that are not inputs
  const int first = likelihood.first_input(), count = static_cast<int>(likelihood.inputs().size());
  for (int i = 0; i < likelihood.parameter_count(); ++i)
    if (i < first || i >= first + count) own.push_back(i);
  const MatrixXd inverse = best.information(own, own).inverse();
  std::vector<ErrorSource> found = {{"noise", std::sqrt(2 * inverse(0, 0)), std::sqrt(2 * inverse(1, 1))}};
  for (int k = 0; k < count; ++k) {
    const VectorXd shift = inverse * best.information(own, std::vector<int>{first + k});
    found.push_back({likelihood.inputs()[static_cast<std::size_t>(k)].name, std::abs(shift[0]), std::abs(shift[1])});
  }
  found.push_back({"numerical", numerical * best.theta[0], numerical * std::abs(best.theta[1])});
  std::ranges::sort(found, std::greater{}, &ErrorSource::Eh_eV_per_A2);
  return found;
}

/// A 95 % interval and the standard error that goes with it, half of what the interval is wide over √threshold: about a
/// free contact, a kink, the Hessian's own is too small by a third.
struct Uncertainty {
  std::array<double, 2> interval;
  double standard_error;
};

Uncertainty uncertainty(const Likelihood& likelihood, const LikelihoodMaximum& best, int parameter, double numerical) {
  const double threshold = profile_threshold(likelihood, confidence), quantile = std::sqrt(threshold);
  const double value = best.theta[parameter], linear = std::sqrt(best.covariance(parameter, parameter));
  const auto [low, high] = profile_interval(likelihood, best, parameter, threshold);
  const auto with_numerical = [&](double half) { return std::hypot(half, quantile * numerical * value); };
  const double half = std::isfinite(high - low) ? (high - low) / 2 : quantile * linear;
  return {{value - with_numerical(value - low), value + with_numerical(high - value)}, with_numerical(half) / quantile};
}

void read_zeros(const Likelihood& likelihood, const LikelihoodMaximum& best, bool profile, Fit& fit) {
  if (const int i = likelihood.contact_index(); i >= 0) {
    fit.contact_nm = nm_per_A * likelihood.contact_depth(best.theta);
    fit.contact_stderr_nm =
        nm_per_A * (profile ? uncertainty(likelihood, best, i, 0).standard_error : std::sqrt(best.covariance(i, i)));
  }
  if (const int i = likelihood.force_zero_index(); i >= 0) {
    fit.force_zero_nN = nN_per_eV_per_A * best.theta[i];
    fit.force_zero_stderr_nN = nN_per_eV_per_A * std::sqrt(best.covariance(i, i));
  }
  if (const int i = likelihood.slope_index(); i >= 0) fit.slope_nN_per_nm = N_per_m_per_eV_per_A2 * best.theta[i];
}

void read_noise(const Likelihood& likelihood, const LikelihoodMaximum& best, Fit& fit) {
  const Noise& noise = likelihood.points().noise;
  const int f = likelihood.force_noise_index(), d = likelihood.depth_noise_index();
  if (noise.force_weight.empty())
    fit.sigma_force_nN = nN_per_eV_per_A * (f >= 0 ? std::sqrt(best.theta[f]) : *noise.force_eV_per_A);
  fit.sigma_depth_nm = nm_per_A * (d >= 0 ? std::sqrt(best.theta[d]) : *noise.depth_A);
}

/// Residuals of the curve, in the order of the points.
void read_residuals(const Likelihood& likelihood, const LikelihoodMaximum& best, Fit& fit) {
  const CurvePoints& points = likelihood.points();
  const Likelihood::Prediction p = likelihood.prediction(best.theta);
  // At the same position of the piezo the curve is deeper where the force is less.
  for (std::size_t i = 0; i < p.miss.size(); ++i)
    fit.fitted_depth_A.push_back(points.depth_A[i] + points.compliance_A2_per_eV * p.miss[i]);
  fit.residual_eV_per_A = p.miss;
  double squares = 0, chi2 = 0;
  for (std::size_t i = 0; i < p.miss.size(); ++i) {
    fit.model_force_eV_per_A.push_back(points.force_eV_per_A[i] - p.miss[i]);
    squares += p.miss[i] * p.miss[i];
    chi2 += std::pow(p.miss[i] / p.sigma[i], 2);
  }
  const auto n = static_cast<double>(p.miss.size());
  fit.points = static_cast<int>(p.miss.size());
  fit.rms_relative = std::sqrt(squares / n) / std::ranges::max(points.force_eV_per_A);
  fit.window_A = {std::ranges::min(points.depth_A), std::ranges::max(points.depth_A)};
  const double freedom = n - static_cast<double>(likelihood.first_input());
  if (likelihood.force_noise_index() < 0 && likelihood.depth_noise_index() < 0) fit.chi2_per_dof = chi2 / freedom;
  std::vector<std::size_t> order(p.miss.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return points.depth_A[i]; });
  std::vector<double> along;
  for (const std::size_t i : order) along.push_back(p.miss[i]);
  fit.runs_z = runs_z(along);
}

/// Refits to the fitted curve with drawn noise.
void bootstrap(const CurvePoints& points, const ForceModel& model, const InferenceOptions& options,
               const Likelihood& likelihood, const LikelihoodMaximum& best, Fit& fit) {
  const Likelihood::Prediction p = likelihood.prediction(best.theta);
  Normal normal(options.seed);
  double n = 0, Eh = 0, Eh2 = 0, pretension = 0, pretension2 = 0;
  for (int sample = 0; sample < options.bootstrap_samples; ++sample) {
    CurvePoints drawn = points;
    for (std::size_t i = 0; i < drawn.force_eV_per_A.size(); ++i) {
      const double change = p.sigma[i] * normal() - p.miss[i];
      drawn.force_eV_per_A[i] += change;
      drawn.depth_A[i] -= drawn.compliance_A2_per_eV * change;
    }
    Likelihood other(std::move(drawn), model, options.free, options.inputs);
    other.take_slopes(best.theta);
    const LikelihoodMaximum found = maximise(other, best.theta);
    if (!found.converged) continue;
    n += 1;
    Eh += found.theta[0];
    Eh2 += std::pow(found.theta[0], 2);
    pretension += found.theta[1];
    pretension2 += std::pow(found.theta[1], 2);
  }
  if (n < 2) return;
  fit.Eh_bootstrap_eV_per_A2 = std::sqrt(std::max(Eh2 - Eh * Eh / n, 0.0) / (n - 1));
  fit.pretension_bootstrap_eV_per_A2 = std::sqrt(std::max(pretension2 - pretension * pretension / n, 0.0) / (n - 1));
}

}  // namespace

double runs_z(const std::vector<double>& residuals) {
  double above = 0, below = 0, runs = 1;
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    (residuals[i] > 0 ? above : below) += 1;
    if (i > 0 && (residuals[i] > 0) != (residuals[i - 1] > 0)) runs += 1;
  }
  if (above < 10 || below < 10) return not_known;
  const double n = above + below, product = 2 * above * below;
  return (1 + product / n - runs) / std::sqrt(product * (product - n) / (n * n * (n - 1)));
}

std::variant<Fit, std::string> infer(const CurvePoints& points, const ForceModel& model,
                                     const InferenceOptions& options) {
  Likelihood likelihood(points, model, options.free, options.inputs);
  if (points.depth_A.size() <= static_cast<std::size_t>(likelihood.parameter_count()))
    return fmt::format("{} points for {} parameters", points.depth_A.size(), likelihood.parameter_count());
  const LikelihoodMaximum best = most_likely(likelihood);
  if (!best.converged) return best.reason;
  Fit fit;
  fit.Eh_eV_per_A2 = best.theta[0];
  fit.pretension_eV_per_A2 = best.theta[1];
  const double numerical = model.relative_error;
  const Uncertainty Eh = uncertainty(likelihood, best, 0, numerical),
                    pretension = uncertainty(likelihood, best, 1, numerical);
  fit.Eh_stderr_eV_per_A2 = Eh.standard_error;
  fit.pretension_stderr_eV_per_A2 = pretension.standard_error;
  fit.Eh_interval_eV_per_A2 = Eh.interval;
  fit.pretension_interval_eV_per_A2 = pretension.interval;
  fit.correlation = best.covariance(0, 1) / std::sqrt(best.covariance(0, 0) * best.covariance(1, 1));
  fit.minus_two_log_likelihood = best.minus_two_log;
  fit.sources = sources(likelihood, best, numerical);
  read_zeros(likelihood, best, options.contact_profile, fit);
  read_noise(likelihood, best, fit);
  read_residuals(likelihood, best, fit);
  bootstrap(points, model, options, likelihood, best, fit);
  return fit;
}

}  // namespace validate
