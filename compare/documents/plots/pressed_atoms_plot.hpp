// Atoms under a pressure beside their membrane.
#pragma once

#include "compare/documents/plots/plot.hpp"
#include "compare/results/result.hpp"

namespace validate {

/// Depth of the centre against pressure where there is more than one pressure, both logarithmic (a membrane's is a line
/// of slope 1/3), and both cross-sections at the last. No panel without a cross-section of both.
Plot pressed_atoms_plot(const Result& result);

}  // namespace validate
