// A drawing as gnuplot's text, in the one style of all figures.
#pragma once

#include <filesystem>
#include <string>

#include "compare/documents/plots/plot.hpp"

namespace validate {

/// The whole script: the data once, then the same commands for an SVG and for a PNG of twice as many pixels. The same
/// plot and paths give the same text.
std::string gnuplot_script(const Plot& plot, const std::filesystem::path& svg, const std::filesystem::path& png);

}  // namespace validate
