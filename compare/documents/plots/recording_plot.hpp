// A recorded curve as a drawing.
#pragma once

#include "compare/documents/plots/plot.hpp"
#include "compare/results/recording.hpp"

namespace validate {

/// Force (or deflection) against height (or depth), and against time where there is one; a colour a segment. Without
/// panels where the columns are not there.
Plot recording_plot(const Recording& recording);

}  // namespace validate
