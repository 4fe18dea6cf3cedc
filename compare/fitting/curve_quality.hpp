// Whether a recorded curve is one of a suspended sheet at all.
#pragma once

#include <optional>
#include <string>

#include "compare/input/measured_curve.hpp"

namespace validate {

/// Why a prepared curve should not count among others: its slope is the substrate's, the force falls in the sheet (slip
/// or break), its baseline is bent (drift). Empty: nothing is seen, or there is no preparation to see it by.
/// `stiffness` (eV/Å²) is the cantilever's, without which the substrate is not told.
std::string looks_wrong(const MeasuredCurve& curve, const std::optional<double>& stiffness);

}  // namespace validate
