// Force against depth: atoms, membranes and Eq. 16 (the paper's Figure 2).
#pragma once

#include "compare/documents/plots/plot.hpp"
#include "compare/results/result.hpp"

namespace validate {

/// A colour per load; markers for atoms (open in the artefact zone, which is shaded), lines for membranes (dashed: the
/// paper's constants) and sheets, a thin black line for Eq. 16 with the constants and the pretension of the
/// like-for-like membrane.
Plot force_depth_plot(const Result& result);

}  // namespace validate
