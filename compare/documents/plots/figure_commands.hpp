// What the figure shows, as gnuplot commands.
#pragma once

#include <string>

#include "compare/results/result.hpp"

namespace validate {

/// Data blocks, axes, legend and the plot command; terminal and output are the caller's. A colour per load;
/// markers for atoms (open in the artefact zone, which is shaded), lines for membranes (dashed: the paper's
/// constants), a thin black line for Eq. 16 with the constants and the pretension of the like-for-like
/// membrane.
std::string figure_commands(const Result& result);

}  // namespace validate
