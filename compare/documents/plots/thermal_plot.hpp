// Force against depth at T = 0 and at the case's temperature.
#pragma once

#include "compare/documents/plots/plot.hpp"
#include "compare/results/result.hpp"

namespace validate {

/// The atoms' curves with what the temperature makes of them, by vibrations and by dynamics, and the ratio of the
/// forces. No panels where nothing was heated.
Plot thermal_plot(const Result& result);

}  // namespace validate
