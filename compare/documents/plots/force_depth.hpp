// The figure of a run: force against depth under each load, and below it what is left between atoms and continuum.
#pragma once

#include "compare/documents/plots/plot.hpp"
#include "compare/results/result.hpp"

namespace validate {

/// A column of panels per load. Above: markers for the atoms (open in the artefact zone, which is shaded), lines for
/// the continua, a thin black one for Eq. 16 with the constants and the pretension of the like-for-like membrane;
/// below, where there are atoms and a continuum, see residual_panel. The verdict is the caption.
Plot force_depth_plot(const Result& result);

/// The same for the load judged alone, as wide as one column of a journal; for the first load where it has no curves.
Plot narrow_force_depth_plot(const Result& result);

}  // namespace validate
