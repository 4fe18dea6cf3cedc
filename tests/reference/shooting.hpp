// The two halves of shooting: an initial value problem and a root. The solvers of this folder share them.
#pragma once

#include <functional>
#include <span>

namespace reference {

using Derivative = std::function<void(double x, std::span<const double> y, std::span<double> dy_dx)>;

/// Carries `state` from `begin` to `end` in `steps` equal steps of the explicit Runge–Kutta pair of Prince
/// and Dormand, order 8 (GSL's rk8pd). Fixed steps make a shot a smooth function of its start, and halving
/// them tells the error. False when the state is no longer finite: the shot went where the equations have no
/// solution.
[[nodiscard]] bool integrate(const Derivative& derivative, double begin, double end, int steps,
                             std::span<double> state);

/// The zero of f between low and high by Brent's method, to rounding. Throws std::runtime_error when f has
/// the same sign at both.
double root(const std::function<double(double)>& f, double low, double high);

/// The zero of an f that changes sign once over the positive numbers: bracketed by doubling and halving
/// `guess`, then Brent's method in ln x.
double positive_root(const std::function<double(double)>& f, double guess);

}  // namespace reference
