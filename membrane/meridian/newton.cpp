#include "membrane/meridian/newton.hpp"

#include <algorithm>
#include <cmath>

#include "membrane/base/line_search.hpp"
#include "membrane/meridian/tuning.hpp"

namespace membrane::meridian {
using Tuning = NewtonTuning;

Newton::Newton(Assembly& assembly) : assembly_(assembly), hessian_(assembly.element_count() + 1) {}

/// Factor of the Hessian, or of the least change of it that is positive definite: the step must go down.
bool Newton::factorise(const Eigen::VectorXd& x) {
  assembly_.hessian(x, hessian_);
  ++factorisations_;
  if (factor_.factorise(hessian_)) return true;
  for (double share = Tuning::first_shift; share < Tuning::most_shift; share *= Tuning::shift_growth) {
    ++factorisations_;
    if (factor_.factorise(hessian_, share)) return true;
  }
  return false;
}

/// Moves x, energy_ and gradient_ along step_ as far as the energy falls enough.
bool Newton::move(Eigen::VectorXd& x) {
  const double noise = Tuning::energy_noise * assembly_.magnitude();
  step_ *= assembly_.longest_share(x, step_);
  double trial_energy = 0;
  const double length = line_search(residual_.dot(step_), [&](double share) {
    trial_ = x + share * step_;
    trial_energy = assembly_.energy(trial_, trial_gradient_);
    return Trial{.change = trial_energy - energy_, .noise = noise, .slope = trial_gradient_.dot(step_) - noise};
  });
  if (length == 0) return false;
  assembly_.advance_pressures(x, length * step_);
  x.swap(trial_);
  gradient_.swap(trial_gradient_);
  energy_ = trial_energy;
  return true;
}

Equilibrium Newton::solve(const Eigen::VectorXd& pattern, Eigen::VectorXd& x) {
  Equilibrium at;
  int stalls = 0;
  energy_ = assembly_.energy(x, gradient_);
  for (; at.iterations <= Tuning::most_searches; ++at.iterations) {
    if (!std::isfinite(energy_) || !factorise(x)) {
      at.reason = "energy or stiffness are not finite";
      return at;
    }
    residual_ = gradient_;
    if (pattern.size() > 0) {
      const Eigen::VectorXd response = factor_.solve(pattern);
      at.force_eV_per_A = response.dot(gradient_) / response.dot(pattern);
      residual_ -= at.force_eV_per_A * pattern;
    }
    step_ = -factor_.solve(residual_);
    double scale = 0;
    for (double part : assembly_.parts()) scale += std::abs(part);
    const double decrement = -residual_.dot(step_);
    const double before = at.relative_residual;
    at.relative_residual = decrement > 0 ? std::sqrt(decrement / scale) : 0;
    stalls = at.iterations > 0 && at.relative_residual > Tuning::stall * before ? stalls + 1 : 0;
    at.converged = at.relative_residual <= Tuning::aim ||
                   (stalls >= Tuning::most_stalls && at.relative_residual <= Tuning::tolerance);
    if (at.converged) return at;
    if (!move(x)) {
      at.reason = "the line search found no lower energy";
      return at;
    }
  }
  at.reason = "no equilibrium within " + std::to_string(Tuning::most_searches) + " iterations";
  return at;
}

}  // namespace membrane::meridian
