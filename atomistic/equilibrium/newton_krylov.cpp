#include "atomistic/equilibrium/newton_krylov.hpp"

#include <algorithm>
#include <cmath>

#include "atomistic/equilibrium/projected_preconditioner.hpp"

namespace atomistic {
namespace {

using Eigen::VectorXd;

constexpr double difference_A = 1e-4;       // largest displacement of an atom in a difference of gradients
constexpr double left_over = 0.1;           // of the gradient's norm that conjugate gradients leave
constexpr int most_products = 250;          // of a step
constexpr double taken = 1e-4;              // a step is taken if this share of what the model promises comes true; …
constexpr double poor = 0.25, good = 0.75;  // … the region shrinks below a poor share and grows from a good one on
constexpr double shrinking = 0.25, growth = 2.5;
constexpr double smallest_region = 1e-10;  // of the gradient's norm

class Newton {
 public:
  Newton(const Minimisation& problem, const MinimiserOptions& options)
      : problem_(problem), options_(options), precondition_(problem) {}

  MinimiserReport run(VectorXd& x, const OnIteration& on_iteration) {
    now_ = evaluate(x);
    double& radius = report_.trust_radius = options_.trust_radius;
    for (;;) {
      const VectorXd residual = precondition_.without_load(now_.gradient);
      report_.max_force = largest_atom_norm(residual, *problem_.team);
      const bool go_on = !on_iteration || on_iteration(report_.evaluations, report_.max_force);
      if (report_.max_force <= options_.force_tolerance) return finish(true, "converged");
      if (!go_on) return finish(false, "given up by the caller");
      if (report_.evaluations >= options_.max_evaluations) return finish(false, "too many force evaluations");
      const VectorXd direction = precondition_(residual);
      const double norm = std::sqrt(std::max(problem_.dot(residual, direction), 0.0));
      if (radius == 0) radius = norm;
      if (radius < smallest_region * norm) return finish(false, "the trust region has shrunk to nothing");
      const Step step = conjugate_gradients(x, residual, direction, norm, radius);
      Evaluation next = evaluate(x + step.s);
      const double share = share_come_true(step, next);
      if (share < poor)
        radius = shrinking * std::min(radius, step.length);
      else if (share > good && step.on_boundary)
        radius *= growth;
      if (share > taken) {
        x += step.s;
        now_ = std::move(next);
      }
    }
  }

 private:
  struct Step {
    VectorXd s;
    double model = 0;   ///< change of the energy that the quadratic model promises
    double length = 0;  ///< in the metric
    bool on_boundary = false;
  };

  /// 1 where the change is lost in rounding.
  double share_come_true(const Step& step, const Evaluation& next) const {
    const double change = next.energy - now_.energy, noise = rounding_floor(now_.energy);
    if (std::abs(step.model) < noise && std::abs(change) < 10 * noise) return 1;
    return change / step.model;
  }

  Evaluation evaluate(const VectorXd& x) {
    ++report_.evaluations;
    return problem_.evaluate(x);
  }

  VectorXd product(const VectorXd& x, const VectorXd& v) {
    const double h = difference_A / largest_atom_norm(v, *problem_.team);
    return (evaluate(x + h * v).gradient - now_.gradient) / h;
  }

  /// Lowers the quadratic model within the region: r is the residual force, direction what the preconditioner makes of
  /// it.
  Step conjugate_gradients(const VectorXd& x, VectorXd r, const VectorXd& direction, double norm, double radius) {
    Step step;
    step.s = VectorXd::Zero(x.size());
    VectorXd p = -direction;
    double rz = norm * norm, ss = 0, sp = 0, pp = rz;  // in the metric: sᵀPs, sᵀPp, pᵀPp
    for (int products = 0; products < most_products && report_.evaluations < options_.max_evaluations; ++products) {
      const VectorXd Hp = product(x, p);
      const double curvature = problem_.dot(p, Hp);
      const double alpha = curvature > 0 ? rz / curvature : 0;
      const double longer = ss + 2 * alpha * sp + alpha * alpha * pp;
      if (!(curvature > 0) || longer >= radius * radius) {
        const double to_boundary = (-sp + std::sqrt(sp * sp + pp * (radius * radius - ss))) / pp;
        step.s += to_boundary * p;
        step.model += to_boundary * problem_.dot(r, p) + 0.5 * to_boundary * to_boundary * curvature;
        step.on_boundary = true;
        ss = radius * radius;
        break;
      }
      step.s += alpha * p;
      step.model -= 0.5 * alpha * rz;
      r += alpha * Hp;
      const VectorXd z = precondition_(r);
      ss = longer;
      const double beta = problem_.dot(r, z) / rz;
      rz = problem_.dot(r, z);
      if (!(std::sqrt(std::max(rz, 0.0)) > left_over * norm)) break;
      sp = beta * (sp + alpha * pp);
      pp = rz + beta * beta * pp;
      p = beta * p - z;
    }
    precondition_.project(step.s);  // rounding
    step.length = std::sqrt(ss);
    return step;
  }

  MinimiserReport finish(bool converged, std::string reason) {
    report_.converged = converged;
    report_.reason = std::move(reason);
    report_.multiplier = precondition_.multiplier(now_.gradient);
    report_.energy_residual = problem_.dot(now_.gradient, precondition_(now_.gradient));
    report_.last = std::move(now_);
    return report_;
  }

  const Minimisation& problem_;
  const MinimiserOptions& options_;
  ProjectedPreconditioner precondition_;
  MinimiserReport report_;
  Evaluation now_;
};

}  // namespace

MinimiserReport minimise_by_newton(const Minimisation& problem, const MinimiserOptions& options, VectorXd& x,
                                   const OnIteration& on_iteration) {
  return Newton(problem, options).run(x, on_iteration);
}

}  // namespace atomistic
