// E·h and pretension against the window of the fit.
#pragma once

#include "compare/documents/plots/plot.hpp"
#include "compare/results/result.hpp"

namespace validate {

/// Two panels side by side: E·h and pretension (N/m) against the largest depth fitted (Å, or nm above 100 Å), for the
/// atoms and the like-for-like (or given) membranes and sheets of a run; known values as thin dashed lines. No panel
/// where nothing is fitted.
Plot window_scan_plot(const Result& result);

}  // namespace validate
