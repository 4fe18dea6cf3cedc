// What a planned experiment will tell, as a picture.
#pragma once

#include "compare/documents/plots/plot.hpp"
#include "compare/results/design.hpp"

namespace validate {

/// The error of E·h as asked for and with one thing changed, the target as a line.
Plot design_plot(const Design& design);

}  // namespace validate
