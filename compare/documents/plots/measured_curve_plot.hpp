// A measured curve and what was fitted to it.
#pragma once

#include "compare/documents/plots/plot.hpp"
#include "compare/fitting/measured_fit.hpp"

namespace validate {

/// Four panels, nm and nN: data with both fits, residuals of the closed form, E·h and pretension (N/m) against the
/// window.
Plot measured_plot(const MeasuredResult& result, const MeasuredOptions& options);

}  // namespace validate
