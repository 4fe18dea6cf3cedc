// What was found in a measured curve, as the terminal shows it.
#pragma once

#include <string>

#include "compare/results/measured.hpp"

namespace validate {

/// A block of lines: E·h and pretension by every model fitted, with intervals and warnings.
std::string measured_text(const FittedCurve& curve);

}  // namespace validate
