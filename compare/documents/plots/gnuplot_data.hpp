// The numbers of a drawing as gnuplot's data blocks.
#pragma once

#include <cstddef>
#include <string>

#include "compare/documents/plots/plot.hpp"

namespace validate {

/// Names of the blocks: of a panel's curve (x, y, upper edge or value), of its map, of its bars (boxxyerror's six).
std::string curve_block(std::size_t panel, std::size_t curve);
std::string map_block(std::size_t panel, std::size_t map);
std::string bar_block(std::size_t panel, std::size_t bars);

/// Every block of the plot.
std::string gnuplot_data(const Plot& plot);

}  // namespace validate
