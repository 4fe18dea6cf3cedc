// A measured curve and what was fitted to it.
#pragma once

#include "compare/documents/plots/plot.hpp"
#include "compare/results/measured.hpp"

namespace validate {

/// Four panels, nm and nN: data with both fits, residuals of the closed form, E·h and pretension (N/m) against the
/// window.
Plot measured_plot(const FittedCurve& curve);

}  // namespace validate
