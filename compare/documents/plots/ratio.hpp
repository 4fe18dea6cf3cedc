// Atoms over each continuum against the relative depth.
#pragma once

#include "compare/documents/plots/plot.hpp"
#include "compare/results/result.hpp"

namespace validate {

/// Force ratios of every comparison against depth / effective radius, open in the artefact zone; the tolerance as a
/// band, the judged window as thin lines. No panel where nothing is compared.
Plot ratio_plot(const Result& result);

}  // namespace validate
