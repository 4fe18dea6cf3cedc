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

/// Of the parameters at the maximum.
void read_uncertainty(const Likelihood& likelihood, const Likelihood::At& here, const std::vector<int>& held,
                      LikelihoodMaximum& result) {
  const Equations equations(likelihood, result.theta, here, held);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(equations.matrix);
  constexpr double ill_conditioned = 1e12;
  if (!(eigen.eigenvalues().minCoeff() > eigen.eigenvalues().maxCoeff() / ill_conditioned)) {
    result.converged = false;
    result.reason = "the points do not determine the parameters";
  }
  const auto scale = equations.scale.asDiagonal();
  const VectorXd inverse_scale = equations.scale.cwiseInverse();
  result.information = inverse_scale.asDiagonal() * equations.matrix * inverse_scale.asDiagonal();
  MatrixXd excess = scale * here.excess * scale;
  VectorXd none = VectorXd::Zero(excess.rows());
  for (const int parameter : equations.held) {
    hold(excess, none, parameter);
    excess(parameter, parameter) = 0;
  }
  const Eigen::LLT<MatrixXd> hessian(equations.matrix - excess);
  const MatrixXd identity = MatrixXd::Identity(excess.rows(), excess.cols());
  // Where most of the information is in the errors, there is no telling.
  const MatrixXd inverse = hessian.info() == Eigen::Success ? MatrixXd(hessian.solve(identity))
                                                            : MatrixXd(equations.matrix.ldlt().solve(identity));
  const MatrixXd sandwich = inverse * equations.matrix * inverse;
  result.widening = sandwich.diagonal().cwiseQuotient(inverse.diagonal()).cwiseMax(1.0);
  result.covariance = 2 * (scale * sandwich * scale);
}

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
  read_uncertainty(likelihood, here, held, result);
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

/// A free contact is a kink among noisy points, and each place of it a minimum nearly.
struct Neighbours {
  const Likelihood& likelihood;
  const LikelihoodMaximum& best;  ///< whose errors are the measure

  /// The lowest minimum that is reached from contacts these standard errors away, if it is lower by more than `least`.
  std::optional<LikelihoodMaximum> below(const LikelihoodMaximum& found, std::initializer_list<double> away,
                                         const std::vector<int>& held, double least) const {
    const int contact = likelihood.contact_index();
    if (contact < 0) return std::nullopt;
    std::optional<LikelihoodMaximum> lowest;
    double lower = found.minus_two_log - least;
    for (const double errors : away) {
      const double there = found.theta[contact] + errors * std::sqrt(best.covariance(contact, contact));
      VectorXd start = moved(best, found.theta, contact, there);
      for (const int parameter : held) start[parameter] = found.theta[parameter];
      if (!(start[0] > 0)) continue;
      keep_noise_positive(likelihood, found.theta, start);
      LikelihoodMaximum other = maximise(likelihood, start, held, 1e-3);
      if (!(other.minus_two_log < lower)) continue;
      lower = other.minus_two_log;
      lowest = std::move(other);
    }
    return lowest;
  }
};

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
    // The start is consistent, a far minimum by chance is not: what is left for has to be lower beyond doubt.
    constexpr double decisive = 3.84;  // χ² of one degree of freedom, 95 %
    const auto other = Neighbours{likelihood, found}.below(found, {-5.0, -2.5, 2.5, 5.0}, {}, decisive);
    if (!other) break;
    theta = other->theta;
  }
  return found;
}

namespace {

/// √ of the growth of −2 ln L with a parameter held away from its best value; follows the others from step to step.
class Profile {
 public:
  Profile(const Likelihood& likelihood, const LikelihoodMaximum& best, int parameter)
      : likelihood_(likelihood), best_(best), parameter_(parameter) {
    last_.theta = best.theta;
  }

  double growth(double value) {
    VectorXd start = moved(best_, last_.theta, parameter_, value);
    keep_noise_positive(likelihood_, last_.theta, start);
    LikelihoodMaximum found = maximise(likelihood_, start, {parameter_}, 1e-7);
    if (!std::isfinite(found.minus_two_log) || found.theta.size() == 0) return std::numeric_limits<double>::infinity();
    last_ = std::move(found);
    return over_best(last_);
  }

  /// Where it was asked last, from other contacts too; follows the lowest from there on.
  double growth_elsewhere() {
    constexpr double negligible = 1e-2;
    if (auto other = Neighbours{likelihood_, best_}.below(last_, {-3.0, 3.0}, {parameter_}, negligible))
      last_ = std::move(*other);
    return over_best(last_);
  }

 private:
  double over_best(const LikelihoodMaximum& found) const {
    return std::sqrt(std::max(found.minus_two_log - best_.minus_two_log, 0.0));
  }

  const Likelihood& likelihood_;
  const LikelihoodMaximum& best_;
  int parameter_;
  LikelihoodMaximum last_;
};

/// One end of a profile, in standard errors from the best value.
class EndSearch {
 public:
  EndSearch(const Likelihood& likelihood, const LikelihoodMaximum& best, int parameter, double sign, double target)
      : profile_(likelihood, best, parameter),
        centre_(best.theta[parameter]),
        unit_(sign * std::sqrt(best.covariance(parameter, parameter))),
        target_(target) {}

  /// About a free contact there may be a further minimum, beside the one that was followed or behind a rise: the end is
  /// what encloses all.
  double end() {
    constexpr int most_minima = 8;
    double x = beyond(0);
    for (int minimum = 0; minimum < most_minima && std::isfinite(x); ++minimum) {
      const std::optional<double> inside = further(x);
      if (!inside) break;
      x = beyond(*inside);
    }
    return centre_ + x * unit_;
  }

 private:
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

  /// A place from `x` on that is inside after all.
  std::optional<double> further(double x) {
    constexpr double clearly = 0.999;
    growth_at(x);
    if (profile_.growth_elsewhere() < clearly * target_) return x;
    for (const double more : {0.5, 1.0})
      if (growth_at(x + more) < clearly * target_) return x + more;
    return std::nullopt;
  }

  double growth_at(double x) { return profile_.growth(centre_ + x * unit_); }

  Profile profile_;
  double centre_, unit_, target_;
};

}  // namespace

std::array<double, 2> profile_interval(const Likelihood& likelihood, const LikelihoodMaximum& best, int parameter,
                                       double threshold) {
  const double target = std::sqrt(threshold * best.widening[parameter]);
  return {EndSearch(likelihood, best, parameter, -1, target).end(),
          EndSearch(likelihood, best, parameter, 1, target).end()};
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
