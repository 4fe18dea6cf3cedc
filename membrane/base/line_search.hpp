// How far along a step a potential energy falls enough.
#pragma once

#include <algorithm>
#include <cmath>

namespace membrane {

/// A length tried: what the energy has changed by, how much of that may be rounding, and the slope that is
/// there (per unit of length).
struct Trial {
  double change = 0, noise = 0, slope = 0;
};

/// The first length of 1, shorter, … at which the energy falls by a share of what the slope at 0 (negative)
/// promises. Where the change drowns in rounding the slope decides instead (approximate Wolfe, Hager & Zhang,
/// SIAM J. Optim. 16 (2005) 170). Calls attempt(length) -> Trial, last with the length that is returned; 0
/// where there is none.
template <class Attempt>
double line_search(double slope, Attempt attempt) {
  constexpr double armijo = 1e-4, shortest = 1e-9;
  for (double length = 1; length > shortest;) {
    const Trial at = attempt(length);
    const bool down =
        std::abs(at.change) > at.noise ? at.change <= armijo * length * slope : at.slope <= 0.9 * std::abs(slope);
    if (down) return length;
    const double parabola = -0.5 * slope * length * length / (at.change - slope * length);
    length = std::isfinite(parabola) ? std::clamp(parabola, 0.1 * length, 0.5 * length) : 0.1 * length;
  }
  return 0;
}

}  // namespace membrane
