// A fitted curve as one row of many.
#pragma once

#include "compare/input/measured_curve.hpp"
#include "compare/results/many.hpp"
#include "compare/results/measured.hpp"

namespace validate {

/// What is known of a curve before it is fitted.
CurveRow row_of(const MeasuredCurve& curve);

/// The same with the fit that is quoted.
CurveRow row_of(const MeasuredCurve& curve, const FittedCurve& fitted);

}  // namespace validate
