// Nonlinear least squares for any closed-form model, and Eq. 16 for a run of the comparison.
#pragma once

#include <Eigen/Core>
#include <concepts>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "compare/result.hpp"

namespace compare {

/// A curve y = f(x; p): a struct with a fixed number of parameters, the value and the gradient over p.
template <class M>
concept CurveModel = requires(const M& model, double x, std::span<const double> parameters,
                              std::span<double> gradient) {
  { M::parameter_count } -> std::convertible_to<int>;
  { model.value(x, parameters) } -> std::convertible_to<double>;
  model.gradient(x, parameters, gradient);
};

struct LeastSquaresOptions {
  std::vector<double> weights;  ///< of the squared residuals; empty: all 1
  bool geodesic_acceleration = false;
  int max_iterations = 200;
};

struct LeastSquaresReport {
  bool converged = false;
  std::string reason;  ///< why not
  int iterations = 0;
  std::vector<double> parameters, standard_errors;
  Eigen::MatrixXd covariance;     ///< scaled by the residual variance
  Eigen::MatrixXd correlation;    ///< known even where the residuals, and with them the covariance, vanish
  double residual_sd = 0;         ///< √(Σ w r² / (n − p))
  std::vector<double> residuals;  ///< y − f, without weights
};

/// The model with its type taken off, so that GSL stays in fit.cpp.
struct AnyCurveModel {
  int parameter_count = 0;
  std::function<double(double, std::span<const double>)> value;
  std::function<void(double, std::span<const double>, std::span<double>)> gradient;
};

/// Minimises Σ w (y − f(x; p))² from `start` (trust region, analytic Jacobian, scaled parameters). Standard
/// errors are those of the covariance (JᵀWJ)⁻¹ times the residual variance. Not converging, too few points,
/// parameters that the points do not determine and non-finite results are reported with a reason, not thrown.
LeastSquaresReport least_squares(const AnyCurveModel& model, std::span<const double> x,
                                 std::span<const double> y, std::span<const double> start,
                                 const LeastSquaresOptions& options = {});

template <CurveModel M>
LeastSquaresReport least_squares(const M& model, std::span<const double> x, std::span<const double> y,
                                 std::span<const double> start, const LeastSquaresOptions& options = {}) {
  const AnyCurveModel any{
      M::parameter_count, [&model](double at, std::span<const double> p) { return model.value(at, p); },
      [&model](double at, std::span<const double> p, std::span<double> g) { model.gradient(at, p, g); }};
  return least_squares(any, x, y, start, options);
}

inline constexpr std::size_t fewest_points_to_fit = 4;

/// Fits Eq. 16 (radius and Poisson's ratio as the run used them) to the run's usable points and sets `fit`,
/// or `fit_skipped` with the reason where there is nothing to trust.
void fit_run(Run& run);

}  // namespace compare
