// How far along a step a potential energy falls enough.
#pragma once

#include <algorithm>
#include <cmath>

namespace membrane {

/// What a length must do to be taken (Hager & Zhang's usual values), and how much shorter the next one is: the
/// parabola's minimum, but no less than a tenth, which one bad value cannot undercut, and no more than half, so that it
/// ends.
struct LineSearchTuning {
  static constexpr double fall = 1e-4, slope = 0.9, shortest = 1e-9;
  static constexpr double least_cut = 0.1, most_cut = 0.5;
};

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
  using Tuning = LineSearchTuning;
  for (double length = 1; length > Tuning::shortest;) {
    const Trial at = attempt(length);
    const bool down = std::abs(at.change) > at.noise ? at.change <= Tuning::fall * length * slope
                                                     : at.slope <= Tuning::slope * std::abs(slope);
    if (down) return length;
    const double parabola = -0.5 * slope * length * length / (at.change - slope * length);
    length = std::isfinite(parabola) ? std::clamp(parabola, Tuning::least_cut * length, Tuning::most_cut * length)
                                     : Tuning::least_cut * length;
  }
  return 0;
}

}  // namespace membrane
