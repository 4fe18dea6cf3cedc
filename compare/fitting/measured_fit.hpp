// A measured curve evaluated: its noise, its zeros and every model that is asked for, all free together.
#pragma once

#include "compare/fitting/measured_options.hpp"
#include "compare/input/measured_curve.hpp"
#include "compare/results/measured.hpp"

namespace validate {

/// Fits the closed form, the membrane itself with its tip and, if asked for, a sheet of another law. Throws Error (bad
/// input) where too few points are left, where forces are negative, and where no model can be fitted, with the reason.
FittedCurve evaluate(const MeasuredCurve& curve, const MeasuredOptions& options);

}  // namespace validate
