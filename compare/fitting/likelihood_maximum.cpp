// Fisher scoring and profiles of a likelihood.
#include <gsl/gsl_cdf.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "compare/fitting/likelihood.hpp"

namespace validate {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Takes parameters out of the equations: their step is 0.
void hold(MatrixXd& information, VectorXd& gradient, int parameter) {
  information.row(parameter).setZero();
  information.col(parameter).setZero();
  information(parameter, parameter) = 1;
  gradient[parameter] = 0;
}

/// The variances that are sought.
std::vector<int> variances(const Likelihood& likelihood) {
  std::vector<int> found;
  for (const int i : {likelihood.force_noise_index(), likelihood.depth_noise_index()})
    if (i >= 0) found.push_back(i);
  return found;
}

/// The Hessian of −2 ln L from differences of its gradient, in parameters of this scale; empty where it is none of a
/// minimum.
MatrixXd observed(const Likelihood& likelihood, const VectorXd& theta, const VectorXd& scale,
                  const std::vector<int>& held) {
  constexpr double step = 1e-2;  // of a scale
  MatrixXd hessian(theta.size(), theta.size());
  for (int i = 0; i < theta.size(); ++i) {
    VectorXd up = theta, down = theta;
    up[i] += step * scale[i];
    down[i] -= step * scale[i];
    const Likelihood::At above = likelihood.at(up), below = likelihood.at(down);
    if (!std::isfinite(above.minus_two_log) || !std::isfinite(below.minus_two_log)) return {};
    hessian.col(i) = (above.gradient - below.gradient).cwiseProduct(scale) / (2 * step);
  }
  hessian = (0.5 * (hessian + hessian.transpose())).eval();
  VectorXd none = VectorXd::Zero(theta.size());
  for (const int parameter : held) hold(hessian, none, parameter);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(hessian, Eigen::EigenvaluesOnly);
  return eigen.eigenvalues().minCoeff() > 1e-9 * eigen.eigenvalues().maxCoeff() ? hessian : MatrixXd();
}

/// The equations of a step, in scaled parameters.
struct Equations {
  MatrixXd matrix;
  VectorXd gradient, scale;
  std::vector<int> held;  ///< with a variance at its border

  Equations(const Likelihood& likelihood, const VectorXd& theta, const Likelihood::At& at, std::vector<int> still)
      : matrix(at.information), gradient(at.gradient), held(std::move(still)) {
    for (const int variance : variances(likelihood))
      if (theta[variance] <= 0 && gradient[variance] >= 0) held.push_back(variance);
    for (const int parameter : held) hold(matrix, gradient, parameter);
    scale = matrix.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    matrix = (scale.asDiagonal() * matrix * scale.asDiagonal()).eval();
    gradient = scale.cwiseProduct(gradient).eval();
  }

  VectorXd step(double damping) const {
    MatrixXd damped = matrix;
    damped.diagonal().array() += damping;
    return -damped.ldlt().solve(gradient);
  }
};

}  // namespace

LikelihoodMaximum maximise(const Likelihood& likelihood, const VectorXd& start, const std::vector<int>& held,
                           double negligible) {
  constexpr int most_iterations = 100;
  constexpr double undamped = 1e-13, slow = 0.1;
  LikelihoodMaximum result;
  result.theta = start;
  Likelihood::At here = likelihood.at(start);
  if (!std::isfinite(here.minus_two_log)) {
    result.reason = "the fit has no finite start";
    return result;
  }
  double damping = 1e-3, decrement = std::numeric_limits<double>::infinity();
  for (result.iterations = 1; result.iterations <= most_iterations; ++result.iterations) {
    Equations equations(likelihood, result.theta, here, held);
    // What −2 ln L can still fall by, twice. Where Fisher's matrix is far from the Hessian, as it is about a contact,
    // that shrinks slowly.
    const double last = std::exchange(decrement, -equations.gradient.dot(equations.step(undamped)));
    result.converged = decrement < negligible;
    if (result.converged) break;
    if (result.iterations > 3 && decrement > slow * last)
      if (MatrixXd hessian = observed(likelihood, result.theta, equations.scale, equations.held); hessian.size() > 0) {
        equations.matrix = std::move(hessian);
        damping = std::min(damping, 1e-6);
      }
    bool moved = false;
    for (; damping < 1e12 && !moved; damping *= moved ? 1 : 8) {
      VectorXd next = result.theta + equations.scale.cwiseProduct(equations.step(damping));
      for (const int variance : variances(likelihood)) next[variance] = std::max(next[variance], 0.0);
      const Likelihood::At there = likelihood.at(next);
      if (!(there.minus_two_log < here.minus_two_log)) continue;
      result.theta = next;
      here = there;
      damping = std::max(damping / 16, 1e-12);
      moved = true;
    }
    if (moved) continue;
    result.converged = decrement < 1e-4;  // rounding: no step lowers it, and little is left
    break;
  }
  if (!result.converged) result.reason = "the fit did not converge";
  result.minus_two_log = here.minus_two_log;
  const Equations equations(likelihood, result.theta, here, held);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(equations.matrix);
  constexpr double most_condition = 1e12;
  if (!(eigen.eigenvalues().minCoeff() > eigen.eigenvalues().maxCoeff() / most_condition)) {
    result.converged = false;
    result.reason = "the points do not determine the parameters";
  }
  const auto scale = equations.scale.asDiagonal();
  result.information =
      equations.scale.cwiseInverse().asDiagonal() * equations.matrix * equations.scale.cwiseInverse().asDiagonal();
  result.covariance = 2 * (scale * equations.matrix.inverse() * scale).eval();
  return result;
}

namespace {

/// Other parameters with one of them elsewhere: they go with it as they are correlated.
VectorXd moved(const LikelihoodMaximum& best, const VectorXd& from, int parameter, double value) {
  VectorXd theta =
      from + best.covariance.col(parameter) / best.covariance(parameter, parameter) * (value - from[parameter]);
  theta[parameter] = value;
  return theta;
}

void keep_noise_positive(const Likelihood& likelihood, const VectorXd& known, VectorXd& theta) {
  for (const int variance : variances(likelihood))
    if (!(theta[variance] >= 0)) theta[variance] = known[variance];
}

/// A free contact is a kink among noisy points, and each place of it a minimum nearly: those beside the one that was
/// found.
std::optional<VectorXd> lower_elsewhere(const Likelihood& likelihood, const LikelihoodMaximum& found) {
  const int contact = likelihood.contact_index();
  if (contact < 0) return std::nullopt;
  constexpr double decisive = 3.84;  // χ² of one degree of freedom, 95 %
  const double sd = std::sqrt(found.covariance(contact, contact));
  std::optional<VectorXd> best;
  double least = found.minus_two_log - decisive;
  for (const double away : {-5.0, -2.5, 2.5, 5.0}) {
    VectorXd start = moved(found, found.theta, contact, found.theta[contact] + away * sd);
    if (!(start[0] > 0)) continue;
    keep_noise_positive(likelihood, found.theta, start);
    const LikelihoodMaximum other = maximise(likelihood, start, {}, 1e-3);
    if (!(other.minus_two_log < least)) continue;
    least = other.minus_two_log;
    best = other.theta;
  }
  return best;
}

}  // namespace

LikelihoodMaximum most_likely(Likelihood& likelihood) {
  constexpr int most_places = 6;
  const bool noise_sought = likelihood.force_noise_index() >= 0 || likelihood.depth_noise_index() >= 0;
  VectorXd theta = likelihood.start();
  LikelihoodMaximum found;
  for (int place = 0; place < most_places; ++place) {
    for (int pass = 0; pass < (noise_sought ? 3 : 2); ++pass) {
      likelihood.take_slopes(theta);
      found = maximise(likelihood, theta);
      if (!found.converged) return found;
      theta = found.theta;
    }
    const std::optional<VectorXd> other = lower_elsewhere(likelihood, found);
    if (!other) break;
    theta = *other;
  }
  return found;
}

namespace {

/// √ of the growth of −2 ln L with a parameter held away from its best value; follows the others from step to step.
class Profile {
 public:
  Profile(const Likelihood& likelihood, const LikelihoodMaximum& best, int parameter)
      : likelihood_(likelihood), best_(best), parameter_(parameter), last_(best.theta) {}

  double growth(double value) {
    VectorXd start = moved(best_, last_, parameter_, value);
    keep_noise_positive(likelihood_, last_, start);
    LikelihoodMaximum found = maximise(likelihood_, start, {parameter_}, 1e-7);
    if (!std::isfinite(found.minus_two_log) || found.theta.size() == 0) return std::numeric_limits<double>::infinity();
    last_ = found.theta;
    return std::sqrt(std::max(found.minus_two_log - best_.minus_two_log, 0.0));
  }

 private:
  const Likelihood& likelihood_;
  const LikelihoodMaximum& best_;
  int parameter_;
  VectorXd last_;
};

/// One end of a profile, in standard errors from the best value.
class EndSearch {
 public:
  EndSearch(const Likelihood& likelihood, const LikelihoodMaximum& best, int parameter, double sign, double target)
      : profile_(likelihood, best, parameter),
        centre_(best.theta[parameter]),
        unit_(sign * std::sqrt(best.covariance(parameter, parameter))),
        target_(target) {}

  /// Where the growth reaches the target beyond `inside`. Its √ is nearly a line: secants, kept between what is inside
  /// and what is outside.
  double beyond(double inside) {
    double inside_growth = 0, outside = 0, outside_growth = 0, x = inside + (inside > 0 ? 0.5 : target_);
    for (int i = 0; i < 40; ++i) {
      const double growth = growth_at(x);
      if (std::isfinite(growth) && std::abs(growth - target_) < 1e-4 * target_) break;
      (growth < target_ ? inside : outside) = x;
      (growth < target_ ? inside_growth : outside_growth) = growth;
      if (!(outside > 0)) {
        if (x > 100) return std::numeric_limits<double>::infinity();
        x = std::min(x * std::clamp(1.05 * target_ / std::max(growth, 1e-3), 1.1, 3.0), 2 * x);
      } else if (std::isfinite(outside_growth)) {
        const double secant =
            inside + (outside - inside) * (target_ - inside_growth) / (outside_growth - inside_growth);
        const double margin = 0.02 * (outside - inside);
        x = std::clamp(secant, inside + margin, outside - margin);
      } else {
        x = (inside + outside) / 2;
      }
      if (outside > 0 && outside - inside < 1e-6 * outside) break;
    }
    return x;
  }

  double growth_at(double x) { return profile_.growth(value_at(x)); }
  double value_at(double x) const { return centre_ + x * unit_; }

 private:
  Profile profile_;
  double centre_, unit_, target_;
};

double end_of(const Likelihood& likelihood, const LikelihoodMaximum& best, int parameter, double sign, double target) {
  EndSearch search(likelihood, best, parameter, sign, target);
  double end = search.beyond(0);
  // About a free contact there may be a further minimum behind a rise: the interval is what encloses all.
  if (likelihood.contact_index() >= 0)
    for (const double more : {0.5, 1.0, 1.5, 2.0})
      if (const double x = end + more; std::isfinite(x) && search.growth_at(x) < target) {
        end = search.beyond(x);
        break;
      }
  return search.value_at(end);
}

}  // namespace

std::array<double, 2> profile_interval(const Likelihood& likelihood, const LikelihoodMaximum& best, int parameter,
                                       double threshold) {
  const double target = std::sqrt(threshold);
  return {end_of(likelihood, best, parameter, -1, target), end_of(likelihood, best, parameter, 1, target)};
}

double profile_threshold(const Likelihood& likelihood, double confidence) {
  if (likelihood.force_noise_index() < 0 && likelihood.depth_noise_index() < 0)
    return gsl_cdf_chisq_Pinv(confidence, 1);
  const auto n = static_cast<double>(likelihood.points().depth_A.size());
  const int noises = (likelihood.force_noise_index() >= 0) + (likelihood.depth_noise_index() >= 0);
  const double freedom = n - (likelihood.parameter_count() - noises - static_cast<double>(likelihood.inputs().size()));
  const double t = gsl_cdf_tdist_Pinv((1 + confidence) / 2, freedom);
  return n * std::log1p(t * t / freedom);
}

}  // namespace validate
