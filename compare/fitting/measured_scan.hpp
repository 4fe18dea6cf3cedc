// E·h and pretension against the part of a measured curve that is fitted.
#pragma once

#include "compare/fitting/likelihood.hpp"
#include "compare/fitting/measured_options.hpp"
#include "compare/results/fit.hpp"

namespace validate {

/// The closed form's fit of the points up to some twenty depths, down to where they determine it no more.
WindowScan scan_of(const CurvePoints& points, const MeasuredOptions& options);

}  // namespace validate
