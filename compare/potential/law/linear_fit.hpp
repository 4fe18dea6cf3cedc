// Linear least squares by GSL.
#pragma once

#include <Eigen/Core>

namespace validate {

struct LinearFit {
  Eigen::VectorXd coefficients;
  Eigen::VectorXd standard_errors;  ///< from the residuals' scatter
  double condition_number = 0;      ///< of the weighted matrix with columns of equal length
};

/// Minimises Σ w_i (y − X c)_i². Throws std::invalid_argument where there are fewer rows than columns or a column that
/// the others make up.
LinearFit linear_fit(const Eigen::MatrixXd& X, const Eigen::VectorXd& y, const Eigen::VectorXd& weights);

/// The coefficients of least norm among those that minimise it, where the rows do not determine all of them.
Eigen::VectorXd least_norm_fit(const Eigen::MatrixXd& X, const Eigen::VectorXd& y, const Eigen::VectorXd& weights);

}  // namespace validate
