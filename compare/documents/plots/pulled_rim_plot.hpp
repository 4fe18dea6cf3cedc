// Force and wrinkles of a sheet whose rim is pulled.
#pragma once

#include "compare/documents/plots/plot.hpp"
#include "compare/results/result.hpp"

namespace validate {

/// Force over that of the cone under a point against depth over radius, with the closed forms as thin lines, and below
/// it the share of the area that is wrinkled or bears compression. Without panels where no rim is pulled.
Plot pulled_rim_plot(const Result& result);

}  // namespace validate
