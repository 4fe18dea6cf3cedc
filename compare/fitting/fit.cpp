#include "compare/fitting/fit.hpp"

#include <fmt/core.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <memory>

namespace validate {

namespace {

struct Data {
  const AnyCurveModel& model;
  std::span<const double> x, y;
};

std::span<const double> view(const gsl_vector* v) { return {v->data, v->size}; }  // stride 1: GSL allocated it

int residuals_callback(const gsl_vector* parameters, void* raw, gsl_vector* residuals) {
  const auto& data = *static_cast<const Data*>(raw);
  for (std::size_t i = 0; i < data.x.size(); ++i) {
    const double r = data.model.value(data.x[i], view(parameters)) - data.y[i];
    if (!std::isfinite(r)) return GSL_EBADFUNC;
    gsl_vector_set(residuals, i, r);
  }
  return GSL_SUCCESS;
}

int jacobian_callback(const gsl_vector* parameters, void* raw, gsl_matrix* jacobian) {
  const auto& data = *static_cast<const Data*>(raw);
  for (std::size_t i = 0; i < data.x.size(); ++i) {
    const std::span<double> row{gsl_matrix_ptr(jacobian, i, 0), jacobian->size2};
    data.model.gradient(data.x[i], view(parameters), row);
    if (!std::ranges::all_of(row, [](double g) { return std::isfinite(g); })) return GSL_EBADFUNC;
  }
  return GSL_SUCCESS;
}

struct FreeWorkspace {
  void operator()(gsl_multifit_nlinear_workspace* w) const { gsl_multifit_nlinear_free(w); }
};
using Workspace = std::unique_ptr<gsl_multifit_nlinear_workspace, FreeWorkspace>;

Workspace make_workspace(const LeastSquaresOptions& options, std::size_t points, std::size_t parameters) {
  gsl_multifit_nlinear_parameters settings = gsl_multifit_nlinear_default_parameters();
  settings.trs = options.geodesic_acceleration ? gsl_multifit_nlinear_trs_lmaccel : gsl_multifit_nlinear_trs_lm;
  settings.scale = gsl_multifit_nlinear_scale_more;  // parameters may differ by many orders of magnitude
  settings.solver = gsl_multifit_nlinear_solver_qr;
  return Workspace(gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &settings, points, parameters));
}

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;  // GSL's order

Eigen::MatrixXd jacobian_of(const gsl_multifit_nlinear_workspace& solver) {
  const gsl_matrix& J = *gsl_multifit_nlinear_jac(&solver);
  return Eigen::Map<const RowMajor, 0, Eigen::OuterStride<>>(J.data, static_cast<Eigen::Index>(J.size1),
                                                             static_cast<Eigen::Index>(J.size2),
                                                             Eigen::OuterStride<>(static_cast<Eigen::Index>(J.tda)));
}

Eigen::Map<const Eigen::VectorXd> as_eigen(const gsl_vector* v) {
  return {v->data, static_cast<Eigen::Index>(v->size)};
}

// GSL's own tests compare a parameter's step with the parameter itself, which never ends for one whose value
// is 0 (no pretension), and an absolute gradient. These two ask the same of the curve and know no units: the
// last step changed the curve by nothing that counts beside the data …
bool step_is_negligible(const gsl_multifit_nlinear_workspace& solver, double data_norm) {
  const Eigen::VectorXd columns = jacobian_of(solver).colwise().norm();
  return (as_eigen(solver.dx).cwiseAbs().array() * columns.array()).maxCoeff() <= 1e-12 * data_norm;
}

// … and the residuals are orthogonal to every column of the Jacobian (MINPACK's gtol), or vanish.
bool is_minimum(const gsl_multifit_nlinear_workspace& solver, double data_norm) {
  const Eigen::MatrixXd jacobian = jacobian_of(solver);
  const Eigen::VectorXd residuals = as_eigen(gsl_multifit_nlinear_residual(&solver));
  if (residuals.norm() <= 1e-10 * data_norm) return true;
  const Eigen::ArrayXd scale = jacobian.colwise().norm().transpose().array() * residuals.norm();
  const Eigen::ArrayXd gradient = (jacobian.transpose() * residuals).cwiseAbs().array();
  return (gradient <= 1e-6 * scale).all();
}

// Iterates to rounding. Returns why that did not succeed, or nothing.
std::string run_to_minimum(gsl_multifit_nlinear_workspace& solver, int max_iterations, double data_norm) {
  for (int i = 0; i < max_iterations; ++i) {
    const int status = gsl_multifit_nlinear_iterate(&solver);
    // No step lowers the sum any more: at rounding level this is what a minimum looks like.
    const bool no_progress = status == GSL_ENOPROG;
    if (status != GSL_SUCCESS && !no_progress) return gsl_strerror(status);
    if (!no_progress && !step_is_negligible(solver, data_norm)) continue;
    return is_minimum(solver, data_norm) ? "" : "the fit stopped before its minimum";
  }
  return fmt::format("the fit did not converge in {} iterations", max_iterations);
}

/// Columns of the Jacobian that are this close to dependent are lost in rounding.
constexpr double most_condition = 1e10;

// Ratio of the smallest to the largest singular value, the columns brought to equal length first: independent
// of the parameters' units.
double reciprocal_condition(Eigen::MatrixXd jacobian) {
  for (Eigen::Index j = 0; j < jacobian.cols(); ++j) {
    const double length = jacobian.col(j).norm();
    if (!(length > 0)) return 0;
    jacobian.col(j) /= length;
  }
  const Eigen::VectorXd singular = Eigen::JacobiSVD<Eigen::MatrixXd>(jacobian).singularValues();
  return singular(singular.size() - 1) / singular(0);
}

// Fills the report from GSL's final state (whose residuals and Jacobian carry √weight). Returns why there is
// no solution to report, or nothing.
std::string read_solution(const gsl_multifit_nlinear_workspace& solver, const Data& data, LeastSquaresReport& report) {
  report.condition_number = 1 / reciprocal_condition(jacobian_of(solver));
  if (!(report.condition_number < most_condition)) return "the points do not determine the parameters";
  const std::size_t points = data.x.size(), p = solver.x->size;
  const double chi2 = as_eigen(gsl_multifit_nlinear_residual(&solver)).squaredNorm();
  const double variance = chi2 / static_cast<double>(points - p);
  report.residual_sd = std::sqrt(variance);
  report.sum_of_squares = chi2;

  RowMajor covariance(p, p);
  gsl_matrix_view into = gsl_matrix_view_array(covariance.data(), p, p);
  gsl_multifit_nlinear_covar(gsl_multifit_nlinear_jac(&solver), 0, &into.matrix);
  report.covariance = variance * covariance;
  const Eigen::VectorXd scale = covariance.diagonal().cwiseSqrt().cwiseInverse();
  report.correlation = scale.asDiagonal() * covariance * scale.asDiagonal();

  const auto solution = view(gsl_multifit_nlinear_position(&solver));
  report.parameters.assign(solution.begin(), solution.end());
  for (const double v : report.covariance.diagonal()) report.standard_errors.push_back(std::sqrt(v));
  for (std::size_t i = 0; i < points; ++i) {
    report.residuals.push_back(data.y[i] - data.model.value(data.x[i], solution));
  }
  return as_eigen(solver.x).allFinite() && report.covariance.allFinite() ? "" : "the fit is not finite";
}

gsl_multifit_nlinear_fdf system_of(Data& data) {
  gsl_multifit_nlinear_fdf system{};
  system.f = residuals_callback;
  system.df = jacobian_callback;
  system.n = data.x.size();
  system.p = static_cast<std::size_t>(data.model.parameter_count);
  system.params = &data;
  return system;
}

double weight_of(const std::vector<double>& weights, std::size_t i) { return weights.empty() ? 1 : weights[i]; }

double norm_of(std::span<const double> y, const std::vector<double>& weights) {
  double squares = 0;
  for (std::size_t i = 0; i < y.size(); ++i) squares += weight_of(weights, i) * y[i] * y[i];
  return std::sqrt(squares);
}

double r_squared(std::span<const double> y, const std::vector<double>& weights, double sum_of_squares) {
  double sum = 0, total = 0, scatter = 0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    sum += weight_of(weights, i) * y[i];
    total += weight_of(weights, i);
  }
  for (std::size_t i = 0; i < y.size(); ++i) scatter += weight_of(weights, i) * std::pow(y[i] - sum / total, 2);
  return 1 - sum_of_squares / scatter;
}

}  // namespace

LeastSquaresReport least_squares(const AnyCurveModel& model, std::span<const double> x, std::span<const double> y,
                                 std::span<const double> start, const LeastSquaresOptions& options) {
  gsl_set_error_handler_off();  // GSL's own handler aborts the program; every status is looked at here
  LeastSquaresReport report;
  const auto parameters = static_cast<std::size_t>(model.parameter_count);
  if (x.size() <= parameters) {
    report.reason = fmt::format("{} points for {} parameters", x.size(), parameters);
    return report;
  }

  Data data{model, x, y};
  gsl_multifit_nlinear_fdf system = system_of(data);
  const Workspace solver = make_workspace(options, x.size(), parameters);
  const auto first = gsl_vector_const_view_array(start.data(), start.size());
  int status = GSL_SUCCESS;
  if (options.weights.empty()) {
    status = gsl_multifit_nlinear_init(&first.vector, &system, solver.get());
  } else {
    const auto weights = gsl_vector_const_view_array(options.weights.data(), options.weights.size());
    status = gsl_multifit_nlinear_winit(&first.vector, &weights.vector, &system, solver.get());
  }
  report.reason = status == GSL_SUCCESS ? run_to_minimum(*solver, options.max_iterations, norm_of(y, options.weights))
                                        : gsl_strerror(status);
  report.iterations = static_cast<int>(gsl_multifit_nlinear_niter(solver.get()));
  if (report.reason.empty()) report.reason = read_solution(*solver, data, report);
  report.converged = report.reason.empty();
  if (report.converged) report.r_squared = r_squared(y, options.weights, report.sum_of_squares);
  return report;
}

double rms(std::span<const double> residuals) {
  double squares = 0;
  for (const double r : residuals) squares += r * r;
  return std::sqrt(squares / static_cast<double>(residuals.size()));
}

}  // namespace validate
