#include "membrane/newton.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace membrane {
namespace {

constexpr double tolerance = 1e-8;
constexpr double rounding = 3e-14;  // of the triangles' forces on the nodes: no residual gets below it
constexpr int most_iterations = 100;
constexpr int chord_steps = 3;          // a factor is kept if that many more steps will do with it
constexpr double armijo = 1e-4;         // share of the promised decrease that a step must deliver
constexpr double energy_noise = 1e-12;  // relative; below it energies do not tell better from worse
constexpr double shortest_step = 1e-8;

/// A sheet that is slack at the given depth carries no load and has no residual.
double relative(double residual, double load) { return residual == 0 ? 0 : residual / load; }

/// Whether the rate of the last step, kept up, ends the search soon: a new factor costs some three steps.
bool keeps_pace(double residual, double before) {
  return residual * std::pow(residual / before, chord_steps) <= tolerance;
}

}  // namespace

Newton::Newton(const Mesh& mesh, Assembly& assembly, Eigen::VectorXd direction)
    : mesh_(mesh), assembly_(assembly), direction_(std::move(direction)) {
  release_held(direction_);
}

void Newton::release_held(Eigen::VectorXd& vector) const {
  for (int n = 0; n < mesh_.node_count(); ++n)
    for (int c = 0; c < 3; ++c)
      if (mesh_.held[n][c]) vector[3 * n + c] = 0;
}

/// Factor of the Hessian, or of the least change of it that is positive definite: the step must go down.
bool Newton::refresh(const Eigen::VectorXd& u) {
  bool done = factor_.factorise(assembly_.hessian(u));
  for (double share : {0.03, 0.1, 0.3})
    if (!done && assembly_.bears_compression()) done = factor_.factorise(assembly_.convex_hessian(u, share));
  if (!done) done = factor_.factorise_shifted(assembly_.convex_hessian(u, 1));
  if (done) response_ = factor_.solve(direction_);
  return done;
}

/// The multiplier of the depth: (g − F q)·K⁻¹ q = 0, so that the step K⁻¹(g − F q) leaves the depth as it is.
double Newton::force_at(const Target& target) const {
  if (target.control == Control::force) return target.value;
  return response_.dot(gradient_) / response_.dot(direction_);
}

/// Force, residual and whether it is small enough, at the u of energy_ and gradient_.
void Newton::measure(const Target& target, Equilibrium& at) {
  at.force_eV_per_A = force_at(target);
  at.energy_eV = energy_;
  at.compliance = response_.dot(direction_);
  residual_ = gradient_ - at.force_eV_per_A * direction_;
  release_held(residual_);
  const double residual = residual_.norm();
  at.relative_residual = relative(residual, std::abs(at.force_eV_per_A) * direction_.norm());
  at.converged = std::isfinite(residual) &&
                 (at.relative_residual <= tolerance || residual <= rounding * assembly_.part_norm());
}

/// Moves u, energy_ and gradient_ along step_ as far as the potential energy U − F d falls enough. Where its
/// change drowns in rounding, the slope decides instead (approximate Wolfe, Hager & Zhang 2005).
bool Newton::line_search(double force, Eigen::VectorXd& u) {
  const double slope = residual_.dot(step_);
  const double work = force * direction_.dot(step_);
  for (double length = 1; length > shortest_step;) {
    trial_ = u + length * step_;
    const double trial_energy = assembly_.energy(trial_, trial_gradient_);
    const double change = trial_energy - energy_ - length * work;
    const double noise = energy_noise * (std::abs(energy_) + std::abs(length * work));
    const bool down = std::abs(change) > noise ? change <= armijo * length * slope
                                               : trial_gradient_.dot(step_) - work <= 0.9 * std::abs(slope);
    if (down) {
      u.swap(trial_);
      gradient_.swap(trial_gradient_);
      energy_ = trial_energy;
      return true;
    }
    const double parabola = -0.5 * slope * length * length / (change - slope * length);
    length = std::isfinite(parabola) ? std::clamp(parabola, 0.1 * length, 0.5 * length) : 0.1 * length;
  }
  return false;
}

Equilibrium Newton::solve(const Target& target, Eigen::VectorXd& u) {
  Equilibrium at;
  energy_ = assembly_.energy(u, gradient_);
  bool wants_factor = true;
  bool fresh = false;  // the factor is that of this very u
  double before = 0;   // relative residual one step ago
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
    if (at.converged) return at;
    if (!fresh && !keeps_pace(at.relative_residual, before)) {
      wants_factor = true;
      continue;
    }
    if (at.iterations == most_iterations) {
      at.reason = "no equilibrium within " + std::to_string(most_iterations) + " iterations";
      return at;
    }
    step_ = -factor_.solve(residual_);
    if (line_search(at.force_eV_per_A, u)) {
      ++at.iterations;
      before = at.relative_residual;
      fresh = false;
    } else if (fresh) {
      at.reason = "the line search found no lower potential energy";
      return at;
    } else {
      wants_factor = true;
    }
  }
}

}  // namespace membrane
