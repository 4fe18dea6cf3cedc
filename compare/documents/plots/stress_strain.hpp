// Stress against strain of a potential's sheet.
#pragma once

#include "compare/documents/plots/plot.hpp"
#include "compare/results/result.hpp"

namespace validate {

/// A curve per direction, nominal stress (N/m) over nominal strain (%), solid up to the artefact length of the bonds
/// and dotted beyond.
Plot stress_strain_plot(const Result& result);

}  // namespace validate
