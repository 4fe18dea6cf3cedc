// Many curves in pictures.
#pragma once

#include "compare/documents/plots/plot.hpp"
#include "compare/results/many.hpp"

namespace validate {

/// E·h, pretension and contact height over the places of the curves; no panels where the places are not known.
Plot many_map(const ManyCurves& many);

/// How E·h and pretension are spread, with mean, spread and the joint E·h.
Plot many_histograms(const ManyCurves& many);

}  // namespace validate
