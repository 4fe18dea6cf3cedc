#include "atomistic/equilibrium/predictor.hpp"

#include <cmath>

namespace atomistic {

using Eigen::VectorXd;

namespace {

VectorXd scaled(const PathState& state, double t) {
  const double s = t / state.t;
  VectorXd u = s * s * state.displacement;
  for (Eigen::Index z = 2; z < u.size(); z += 3) u[z] = s * state.displacement[z];
  return u;
}

/// Extrapolated over so many of the last steps, what the minimisations have left of each state tears the sheet.
bool is_far(const std::vector<PathState>& states, double t) {
  constexpr double most_steps = 20;
  const std::size_t n = states.size();
  const double last = states[n - 1].t, before = n > 1 ? states[n - 2].t : 0;
  return std::abs(t - last) > most_steps * std::abs(last - before);
}

}  // namespace

VectorXd extrapolate(const std::vector<PathState>& states, double t) {
  const std::size_t n = states.size();
  if (n == 1 || is_far(states, t)) return scaled(states.back(), t);
  const std::size_t first = n >= 3 ? n - 3 : 0;  // Lagrange through the newest two or three
  VectorXd u = VectorXd::Zero(states.back().displacement.size());
  for (std::size_t i = first; i < n; ++i) {
    double weight = 1;
    for (std::size_t j = first; j < n; ++j)
      if (j != i) weight *= (t - states[j].t) / (states[i].t - states[j].t);
    u += weight * states[i].displacement;
  }
  return u;
}

VectorXd extrapolate(const std::vector<PathState>& states, double t, const std::optional<VectorXd>& guide) {
  if (!guide) return extrapolate(states, t);
  if (states.empty() || is_far(states, t)) return *guide;
  std::vector<PathState> rest;
  for (const PathState& state : states) {
    if (!state.guide) return extrapolate(states, t);
    rest.push_back({state.t, state.displacement - *state.guide, {}});
  }
  return *guide + extrapolate(rest, t);
}

}  // namespace atomistic
