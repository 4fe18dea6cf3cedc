// What is left between the atoms and the continuum that they are held against.
#pragma once

#include <optional>

#include "compare/documents/plots/plot.hpp"
#include "compare/results/result.hpp"

namespace validate {

/// Atoms over the continuum less one, in per cent, against depth (in the units that are shown) up to `depth_end`: the
/// sheet where the comparison has one, else the membrane. Bars are the 95 % uncertainty of the ratios judged,
/// green is the tolerance, dotted the judged window. Nothing without ratios.
std::optional<Panel> residual_panel(const Result& result, LoadKind load, double depth_end);

}  // namespace validate
