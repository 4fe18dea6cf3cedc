#include "atomistic/equilibrium/minimiser.hpp"

#include <algorithm>
#include <cmath>
#include <deque>

#include "atomistic/equilibrium/projected_preconditioner.hpp"

namespace atomistic {
namespace {

using Eigen::VectorXd;

struct Pair {
  VectorXd s, y;
  double rho;
};

/// Two-loop recursion with the projected preconditioner as the first inverse Hessian.
VectorXd descent_direction(const Minimisation& problem, const VectorXd& gradient, const std::deque<Pair>& pairs,
                           const ProjectedPreconditioner& p) {
  VectorXd q = gradient;
  std::vector<double> alpha(pairs.size());
  for (std::size_t k = pairs.size(); k-- > 0;) {
    alpha[k] = pairs[k].rho * problem.dot(pairs[k].s, q);
    q -= alpha[k] * pairs[k].y;
  }
  VectorXd r = p(q);
  for (std::size_t k = 0; k < pairs.size(); ++k)
    r += (alpha[k] - pairs[k].rho * problem.dot(pairs[k].y, r)) * pairs[k].s;
  p.project(r);  // rounding in the history would grow from one iteration to the next
  return -r;
}

/// Armijo's condition; where rounding hides it, the same condition on the slope (the approximate Wolfe
/// condition of Hager and Zhang, SIAM J. Optim. 16 (2005) 170), which rounding does not touch.
bool decreases_enough(const Minimisation& problem, const Evaluation& from, const Evaluation& to, const VectorXd& step,
                      double fraction, double slope) {
  constexpr double c = 1e-4;
  const double change = to.energy - from.energy;
  if (change <= c * fraction * slope) return true;
  return change <= rounding_floor(from.energy) &&
         std::abs(problem.dot(step, to.gradient)) <= (1 - 2 * c) * std::abs(slope);
}

}  // namespace

MinimiserReport minimise(const Minimisation& problem, const MinimiserOptions& options, VectorXd& x,
                         const OnIteration& on_iteration) {
  const ProjectedPreconditioner preconditioner(problem);
  std::deque<Pair> pairs;
  MinimiserReport report;
  Evaluation now = problem.evaluate(x);
  report.evaluations = 1;

  const auto finish = [&](bool converged, std::string reason) {
    report.converged = converged;
    report.reason = std::move(reason);
    report.multiplier = preconditioner.multiplier(now.gradient);
    report.energy_residual = problem.dot(now.gradient, preconditioner(now.gradient));
    report.last = std::move(now);
    return report;
  };

  for (;;) {
    report.max_force = largest_atom_norm(preconditioner.without_load(now.gradient), *problem.team);
    const bool go_on = !on_iteration || on_iteration(report.evaluations, report.max_force);
    if (report.max_force <= options.force_tolerance) return finish(true, "converged");
    if (!go_on) return finish(false, "given up by the caller");

    VectorXd step = descent_direction(problem, now.gradient, pairs, preconditioner);
    double slope = problem.dot(step, now.gradient);
    if (!(slope < 0)) {  // the history has gone stale
      if (pairs.empty()) return finish(false, "the preconditioned gradient is not a descent direction");
      pairs.clear();
      continue;
    }
    if (const double longest = largest_atom_norm(step, *problem.team); longest > options.longest_step) {
      step *= options.longest_step / longest;
      slope *= options.longest_step / longest;
    }

    double fraction = 1;
    for (;;) {  // Armijo, by quadratic interpolation
      if (report.evaluations >= options.max_evaluations) return finish(false, "too many force evaluations");
      Evaluation next = problem.evaluate(x + fraction * step);
      ++report.evaluations;
      if (decreases_enough(problem, now, next, step, fraction, slope)) {
        Pair pair{fraction * step, next.gradient - now.gradient, 0};
        const double curvature = problem.dot(pair.s, pair.y);
        x += pair.s;
        if (curvature > 1e-12 * problem.norm(pair.s) * problem.norm(pair.y)) {
          pair.rho = 1 / curvature;
          pairs.push_back(std::move(pair));
          if (pairs.size() > static_cast<std::size_t>(options.memory)) pairs.pop_front();
        }
        now = std::move(next);
        break;
      }
      const double excess = next.energy - now.energy - fraction * slope;
      fraction *= std::clamp(-fraction * slope / (2 * excess), 0.1, 0.5);
      if (fraction < 1e-6) {
        if (pairs.empty()) return finish(false, "the line search found no decrease");
        pairs.clear();
        break;
      }
    }
  }
}

}  // namespace atomistic
