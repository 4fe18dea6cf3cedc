// From a measured file to points that can be fitted: depths, given zeros, window and noise.
#pragma once

#include "compare/fitting/likelihood.hpp"
#include "compare/fitting/measured_options.hpp"
#include "compare/input/measured_curve.hpp"

namespace validate {

/// The points inside the window, given zeros taken off, with what is known of their noise; sets the baseline that was
/// taken off (eV/Å). Throws Error (bad input) where too few points are left, where the force does not grow with the
/// depth, and where a height has no spring constant.
CurvePoints measured_points(const MeasuredCurve& curve, const MeasuredOptions& options, double& baseline_eV_per_A);

}  // namespace validate
