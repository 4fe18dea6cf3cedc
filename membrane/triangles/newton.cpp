#include "membrane/triangles/newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "membrane/base/line_search.hpp"
#include "membrane/triangles/tuning.hpp"

namespace membrane {
namespace {

using Tuning = NewtonTuning;

/// A sheet that is slack at the given depth carries no load and has no residual.
double relative(double residual, double load) { return residual == 0 ? 0 : residual / load; }

/// Whether the rate of the last step, kept up, ends the search within that many steps.
bool keeps_pace(double residual, double before, double tolerance, int steps) {
  return residual * std::pow(residual / before, steps) <= tolerance;
}

}  // namespace

Newton::Newton(TotalEnergy& energy, Eigen::VectorXd direction, Triangles options)
    : total_(energy), options_(options), direction_(std::move(direction)) {
  total_.release_held(direction_);
}

/// Factor of the Hessian, or of the least change of it that is positive definite: the step must go down.
bool Newton::factorise(const Eigen::VectorXd& u) {
  pivot_sign_ = 1;
  if (factor_.factorise(total_.hessian(u), damping_)) return true;
  pivot_sign_ = 0;
  if (factor_.factorise_singular(total_.hessian(u))) return true;
  pivot_sign_ = -1;
  for (double share : Tuning::softened)
    if (factor_.factorise(total_.hessian(u, share), damping_)) return true;
  const Hessian::Matrix& positive = total_.hessian(u, 1);
  for (; damping_ <= 1; damping_ = std::max(Tuning::damping_growth * damping_, Tuning::least_damping))
    if (factor_.factorise(positive, damping_)) return true;
  damping_ = 0;
  return false;
}

bool Newton::refresh(const Eigen::VectorXd& u) {
  const bool done = factorise(u);
  if (done) response_ = factor_.solve(direction_);
  return done;
}

Eigen::VectorXd Newton::linear_response(const Eigen::VectorXd& u, const Eigen::VectorXd& right_side) {
  if (!factorise(u)) return Eigen::VectorXd::Constant(right_side.size(), std::numeric_limits<double>::quiet_NaN());
  return factor_.solve(right_side);
}

Softest Newton::softest_at(const Eigen::VectorXd& u) { return softest(total_, factor_, u, direction_); }

bool Newton::leave_saddle(const Softest& direction, double smallest_A, Eigen::VectorXd& u) {
  return direction.stiffness_eV_per_A2 < 0 && step_off(total_, direction, smallest_A, u);
}

/// The multiplier of the depth: (g − F q)·K⁻¹ q = 0, so that the step K⁻¹(g − F q) leaves the depth as it is.
double Newton::force_at(const Target& target) const {
  if (target.control == Control::force) return target.value;
  return response_.dot(gradient_) / response_.dot(direction_);
}

/// What the residual is compared with: the load on the sheet, or what holds it against loads of other kinds.
double Newton::load_norm(double force) const {
  const double load = std::abs(force) * direction_.norm();
  if (load > 0) return load;
  return dead_load_ > 0 ? dead_load_ : (gradient_ - residual_).norm();  // the held part
}

/// Whether the supports carry the load across the sheet: what is missing is the sum of the residual.
bool Newton::balanced() const {
  const auto across = [](const Eigen::VectorXd& v) { return v.reshaped(3, v.size() / 3).row(2).sum(); };
  Eigen::VectorXd free = gradient_;
  total_.release_held(free);
  return std::abs(across(residual_)) <= options_.relative_residual * std::abs(across(gradient_ - free));
}

/// Force, residual and whether it is small enough, at the u of energy_ and gradient_.
void Newton::measure(const Target& target, Equilibrium& at) {
  multiplier_ = force_at(target);
  at.force_eV_per_A = multiplier_ + (target.curved ? target.curved->force() : 0);
  at.energy_eV = energy_;
  at.compliance = response_.dot(direction_);
  at.smallest_pivot_sign = pivot_sign_;
  residual_ = gradient_ - multiplier_ * direction_;
  total_.release_held(residual_);
  const double residual = residual_.norm();
  at.relative_residual = relative(residual, load_norm(at.force_eV_per_A));
  at.converged = std::isfinite(residual) && ((at.relative_residual <= options_.relative_residual && balanced()) ||
                                             residual <= Tuning::rounding * total_.part_norm());
}

/// A curved depth's direction turns with u, and what the multiplier found missing of its force belongs to its
/// energy.
void Newton::follow_curve(const Target& target, const Eigen::VectorXd& u) {
  if (!target.curved) return;
  target.curved->set_force(target.curved->force() + multiplier_);
  multiplier_ = 0;
  energy_ = total_.energy(u, gradient_);
  direction_ = target.curved->direction(u);
  total_.release_held(direction_);
  if (factor_.ready()) response_ = factor_.solve(direction_);
}

/// A short step says that the tangent promised too much: the next ones are held shorter. Wrinkled and slack zones of a
/// sheet that is free to slide leave valleys without curvature, in which undamped steps are long and go nowhere.
void Newton::adapt_damping(double step_length) {
  if (step_length < Tuning::short_step)
    damping_ = std::max(Tuning::damping_pace * damping_, Tuning::least_damping);
  else if (step_length == 1)
    damping_ = damping_ > Tuning::least_damping ? damping_ / Tuning::damping_pace : 0;
}

/// Moves u, energy_ and gradient_ along step_ as far as the potential energy U − F d falls enough.
bool Newton::move(const Target& target, Eigen::VectorXd& u) {
  const double work = multiplier_ * direction_.dot(step_);
  double trial_energy = 0;
  const double length = line_search(residual_.dot(step_), [&](double share) {
    trial_ = u + share * step_;
    if (target.curved) target.curved->restore(target.value, trial_);
    trial_energy = total_.energy(trial_, trial_gradient_);
    return Trial{.change = trial_energy - energy_ - share * work,
                 .noise = Tuning::energy_noise * (std::abs(energy_) + std::abs(share * work)) +
                          Tuning::energy_rounding * total_.counted_from(),
                 .slope = trial_gradient_.dot(step_) - work};
  });
  if (length == 0) return false;
  adapt_damping(length);
  u.swap(trial_);
  gradient_.swap(trial_gradient_);
  energy_ = trial_energy;
  return true;
}

Equilibrium Newton::solve(const Target& target, Eigen::VectorXd& u, FirstFactor first) {
  Equilibrium at;
  if (target.curved) target.curved->restore(target.value, u);
  energy_ = total_.energy(u, gradient_);
  multiplier_ = 0;
  follow_curve(target, u);
  damping_ = 0;
  bool wants_factor = first == FirstFactor::fresh || !factor_.ready();
  bool fresh = false;                                       // the factor is that of this very u
  double before = std::numeric_limits<double>::infinity();  // relative residual one step ago
  while (true) {
    if (wants_factor) {
      if (!refresh(u)) {
        at.reason = "the tangent stiffness is not finite";
        return at;
      }
      fresh = true;
      wants_factor = false;
    }
    measure(target, at);
    if (at.converged || at.iterations == options_.most_iterations) break;
    if (!fresh && !(options_.keep_factor &&
                    keeps_pace(at.relative_residual, before, options_.relative_residual, factor_.steps_worth()))) {
      wants_factor = true;
      continue;
    }
    step_ = -factor_.solve(residual_);
    if (move(target, u)) {
      follow_curve(target, u);
      at.residual_history.push_back(at.relative_residual);
      ++at.iterations;
      before = at.relative_residual;
      fresh = false;
    } else if (fresh && damping_ < Tuning::most_damping) {
      damping_ = std::max(Tuning::stuck_growth * damping_, Tuning::least_damping);
      wants_factor = true;
    } else if (fresh) {
      at.reason = "the line search found no lower potential energy";
      return at;
    } else {
      wants_factor = true;
    }
  }
  follow_curve(target, u);
  at.residual_history.push_back(at.relative_residual);
  if (!at.converged) at.reason = "no equilibrium within " + std::to_string(options_.most_iterations) + " iterations";
  return at;
}

}  // namespace membrane
