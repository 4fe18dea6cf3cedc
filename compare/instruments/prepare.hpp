// From an instrument's raw segment to force and depth.
#pragma once

#include <vector>

#include "compare/input/measured_curve.hpp"

namespace validate {

/// The way back of the same cycle, raw like the curve's heights and forces.
struct WayBack {
  std::vector<double> height_A, force_eV_per_A;
};

/// Turns heights and forces so that they grow where the tip presses, takes the baseline off, puts the zero of the
/// heights at the first estimate of the contact and leaves the points of a snap-in out; says each in `preparation` and
/// `notes`. A curve without ten points before the contact keeps its forces. Throws Error (bad input) where the force
/// never rises above the baseline's noise.
void prepare(MeasuredCurve& curve, Baseline baseline, const WayBack& back);

}  // namespace validate
