// Nonlinear least squares for any model of a curve.
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "compare/fitting/models/curve_model.hpp"

namespace validate {

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
  double sum_of_squares = 0;      ///< Σ w r²
  double r_squared = 0;           ///< 1 − Σ w r² / Σ w (y − mean)²
  double condition_number = 0;    ///< of the Jacobian, its columns brought to equal length
  std::vector<double> residuals;  ///< y − f, without weights
};

/// Minimises Σ w (y − f(x; p))² from `start` (trust region, analytic Jacobian, scaled parameters). Standard
/// errors are those of the covariance (JᵀWJ)⁻¹ times the residual variance. Not converging, too few points,
/// parameters that the points do not determine and non-finite results are reported with a reason, not thrown.
LeastSquaresReport least_squares(const AnyCurveModel& model, std::span<const double> x, std::span<const double> y,
                                 std::span<const double> start, const LeastSquaresOptions& options = {});

template <CurveModel M>
LeastSquaresReport least_squares(const M& model, std::span<const double> x, std::span<const double> y,
                                 std::span<const double> start, const LeastSquaresOptions& options = {}) {
  return least_squares(any_model(model), x, y, start, options);
}

/// Root mean square.
double rms(std::span<const double> residuals);

}  // namespace validate
