#include "compare/fitting/fit_intervals.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace validate {
namespace {

/// The model with one parameter held.
AnyCurveModel held(const AnyCurveModel& model, std::size_t index, double value) {
  const auto all = [index, value](std::span<const double> others) {
    std::vector<double> p(others.begin(), others.end());
    p.insert(p.begin() + static_cast<std::ptrdiff_t>(index), value);
    return p;
  };
  return {model.parameter_count - 1,
          [&model, all](double x, std::span<const double> p) { return model.value(x, all(p)); },
          [&model, all, index](double x, std::span<const double> p, std::span<double> g) {
            std::vector<double> whole(p.size() + 1);
            model.gradient(x, all(p), whole);
            whole.erase(whole.begin() + static_cast<std::ptrdiff_t>(index));
            std::ranges::copy(whole, g.begin());
          }};
}

class Profile {
 public:
  Profile(const AnyCurveModel& model, std::span<const double> x, std::span<const double> y,
          const LeastSquaresReport& report, const LeastSquaresOptions& options, std::size_t index)
      : model_(model), x_(x), y_(y), report_(report), options_(options), index_(index) {}

  /// End of the interval on one side (sign), where the least sum of squares reaches `limit`.
  double end(double sign, double limit) {
    const double centre = report_.parameters[index_], step = sign * report_.standard_errors[index_];
    double inside = 0, outside = 1;
    while (sum_of_squares(centre + outside * step) < limit) {
      inside = outside;
      outside *= 2;
      if (outside > 100) return sign * std::numeric_limits<double>::infinity();
    }
    for (int i = 0; i < 60 && outside - inside > 1e-9 * outside; ++i) {
      const double middle = (inside + outside) / 2;
      (sum_of_squares(centre + middle * step) < limit ? inside : outside) = middle;
    }
    return centre + outside * step;
  }

 private:
  double sum_of_squares(double value) {
    if (model_.parameter_count == 1) {
      double sum = 0;
      for (std::size_t i = 0; i < x_.size(); ++i) {
        const double weight = options_.weights.empty() ? 1 : options_.weights[i];
        sum += weight * std::pow(y_[i] - model_.value(x_[i], std::span(&value, 1)), 2);
      }
      return sum;
    }
    std::vector<double> start = report_.parameters;
    start.erase(start.begin() + static_cast<std::ptrdiff_t>(index_));
    const LeastSquaresReport fit = least_squares(held(model_, index_, value), x_, y_, start, options_);
    return fit.converged ? fit.sum_of_squares : std::numeric_limits<double>::infinity();
  }

  const AnyCurveModel& model_;
  std::span<const double> x_, y_;
  const LeastSquaresReport& report_;
  const LeastSquaresOptions& options_;
  std::size_t index_;
};

/// A number below n from the generator's own bits: std's distributions differ between libraries.
std::size_t draw(std::mt19937& random, std::size_t n) {
  return static_cast<std::size_t>((static_cast<std::uint64_t>(random()) * n) >> 32);
}

double percentile(const std::vector<double>& sorted, double fraction) {
  const double at = fraction * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], at - static_cast<double>(below));
}

/// √weight × residual, centred, with the spread that the errors have rather than the residuals.
std::vector<double> scaled_residuals(const LeastSquaresReport& report, const std::vector<double>& weights,
                                     std::size_t parameters) {
  const auto n = static_cast<double>(report.residuals.size());
  std::vector<double> scaled = report.residuals;
  double mean = 0;
  for (std::size_t i = 0; i < scaled.size(); ++i) {
    scaled[i] *= weights.empty() ? 1 : std::sqrt(weights[i]);
    mean += scaled[i] / n;
  }
  for (double& r : scaled) r = (r - mean) * std::sqrt(n / (n - static_cast<double>(parameters)));
  return scaled;
}

}  // namespace

std::vector<Interval> profile_intervals(const AnyCurveModel& model, std::span<const double> x,
                                        std::span<const double> y, const LeastSquaresReport& report,
                                        const LeastSquaresOptions& options, double confidence) {
  const auto freedom = static_cast<double>(x.size()) - model.parameter_count;
  const double t = gsl_cdf_tdist_Pinv((1 + confidence) / 2, freedom);
  const double limit = report.sum_of_squares * (1 + t * t / freedom);
  std::vector<Interval> intervals;
  for (std::size_t i = 0; i < report.parameters.size(); ++i) {
    // Data that the curve meets to rounding leave nothing to follow.
    if (!(report.standard_errors[i] > 1e-12 * std::abs(report.parameters[i]))) {
      intervals.push_back({report.parameters[i], report.parameters[i]});
      continue;
    }
    Profile profile(model, x, y, report, options, i);
    intervals.push_back({profile.end(-1, limit), profile.end(1, limit)});
  }
  return intervals;
}

Bootstrap bootstrap(const AnyCurveModel& model, std::span<const double> x, const LeastSquaresReport& report,
                    const LeastSquaresOptions& options, int samples, std::uint32_t seed, double confidence) {
  const std::size_t parameters = report.parameters.size();
  const std::vector<double> residuals = scaled_residuals(report, options.weights, parameters);
  std::mt19937 random(seed);
  std::vector<std::vector<double>> found(parameters);
  std::vector<double> y(x.size());
  for (int s = 0; s < samples; ++s) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double spread = options.weights.empty() ? 1 : 1 / std::sqrt(options.weights[i]);
      y[i] = model.value(x[i], report.parameters) + spread * residuals[draw(random, residuals.size())];
    }
    const LeastSquaresReport again = least_squares(model, x, y, report.parameters, options);
    if (!again.converged) continue;
    for (std::size_t j = 0; j < parameters; ++j) found[j].push_back(again.parameters[j]);
  }
  Bootstrap result;
  if (found.empty() || found[0].size() < 2) return result;
  result.samples = static_cast<int>(found[0].size());
  for (auto& values : found) {
    double mean = 0, variance = 0;
    for (const double v : values) mean += v / result.samples;
    for (const double v : values) variance += (v - mean) * (v - mean) / (result.samples - 1);
    std::ranges::sort(values);
    result.standard_errors.push_back(std::sqrt(variance));
    result.intervals.push_back({percentile(values, (1 - confidence) / 2), percentile(values, (1 + confidence) / 2)});
  }
  return result;
}

AnyCurveModel with_offsets(AnyCurveModel model, bool depth_offset, bool force_offset) {
  if (!depth_offset && !force_offset) return model;
  const auto inner = static_cast<std::size_t>(model.parameter_count);
  const auto shift = [=](std::span<const double> p) { return depth_offset ? p[inner] : 0.0; };
  const auto lift = [=](std::span<const double> p) { return force_offset ? p.back() : 0.0; };
  return {model.parameter_count + depth_offset + force_offset,
          [=](double x, std::span<const double> p) { return model.value(x - shift(p), p.first(inner)) + lift(p); },
          [=](double x, std::span<const double> p, std::span<double> g) {
            const double at = x - shift(p);
            model.gradient(at, p.first(inner), g.first(inner));
            if (depth_offset) {  // −df/dx by a central difference
              const double h = 6e-6 * std::max(std::abs(at), std::abs(x) * 1e-2 + 1e-12);
              g[inner] = -(model.value(at + h, p.first(inner)) - model.value(at - h, p.first(inner))) / (2 * h);
            }
            if (force_offset) g.back() = 1;
          }};
}

}  // namespace validate
