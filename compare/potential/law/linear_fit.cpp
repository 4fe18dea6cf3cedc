#include "compare/potential/law/linear_fit.hpp"

#include <fmt/format.h>
#include <gsl/gsl_multifit.h>

#include <Eigen/SVD>
#include <memory>
#include <stdexcept>

namespace validate {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;  // GSL's order

struct FreeWorkspace {
  void operator()(gsl_multifit_linear_workspace* w) const { gsl_multifit_linear_free(w); }
};

double condition_of(const Eigen::MatrixXd& X, const Eigen::VectorXd& weights) {
  Eigen::MatrixXd scaled = weights.cwiseSqrt().asDiagonal() * X;
  scaled.colwise().normalize();
  const Eigen::VectorXd singular = Eigen::JacobiSVD<Eigen::MatrixXd>(scaled).singularValues();
  return singular(0) / singular(singular.size() - 1);
}

}  // namespace

LinearFit linear_fit(const Eigen::MatrixXd& X, const Eigen::VectorXd& y, const Eigen::VectorXd& weights) {
  const auto n = static_cast<std::size_t>(X.rows()), p = static_cast<std::size_t>(X.cols());
  if (n <= p) throw std::invalid_argument(fmt::format("{} values do not determine {} coefficients", n, p));
  LinearFit fit;
  fit.condition_number = condition_of(X, weights);
  constexpr double most_condition = 1e10;
  if (!(fit.condition_number < most_condition))
    throw std::invalid_argument(fmt::format("the states do not tell the {} coefficients apart", p));

  RowMajor rows = X, covariance(X.cols(), X.cols());
  Eigen::VectorXd values = y, w = weights;
  fit.coefficients.resize(X.cols());
  auto matrix = gsl_matrix_view_array(rows.data(), n, p), cov = gsl_matrix_view_array(covariance.data(), p, p);
  auto y_view = gsl_vector_view_array(values.data(), n), w_view = gsl_vector_view_array(w.data(), n);
  auto c_view = gsl_vector_view_array(fit.coefficients.data(), p);
  const std::unique_ptr<gsl_multifit_linear_workspace, FreeWorkspace> work(gsl_multifit_linear_alloc(n, p));
  double chi_squared = 0;
  gsl_multifit_wlinear(&matrix.matrix, &w_view.vector, &y_view.vector, &c_view.vector, &cov.matrix, &chi_squared,
                       work.get());
  const double scatter = chi_squared / static_cast<double>(n - p);
  fit.standard_errors = (scatter * covariance.diagonal()).cwiseMax(0).cwiseSqrt();
  return fit;
}

Eigen::VectorXd least_norm_fit(const Eigen::MatrixXd& X, const Eigen::VectorXd& y, const Eigen::VectorXd& weights) {
  constexpr double tolerance = 1e-9;  // singular values below this share of the largest count as zero
  const auto n = static_cast<std::size_t>(X.rows()), p = static_cast<std::size_t>(X.cols());
  if (n < p) throw std::invalid_argument(fmt::format("{} values are too few for {} coefficients", n, p));
  RowMajor rows = X, covariance(X.cols(), X.cols());
  Eigen::VectorXd values = y, w = weights, coefficients(X.cols());
  auto matrix = gsl_matrix_view_array(rows.data(), n, p), cov = gsl_matrix_view_array(covariance.data(), p, p);
  auto y_view = gsl_vector_view_array(values.data(), n), w_view = gsl_vector_view_array(w.data(), n);
  auto c_view = gsl_vector_view_array(coefficients.data(), p);
  const std::unique_ptr<gsl_multifit_linear_workspace, FreeWorkspace> work(gsl_multifit_linear_alloc(n, p));
  double chi_squared = 0;
  std::size_t rank = 0;
  gsl_multifit_wlinear_tsvd(&matrix.matrix, &w_view.vector, &y_view.vector, tolerance, &c_view.vector, &cov.matrix,
                            &chi_squared, &rank, work.get());
  return coefficients;
}

}  // namespace validate
