// Where the panels of a drawing stand, and what stands around them: letters and the caption.
#pragma once

#include <cstddef>
#include <string>

#include "compare/documents/plots/plot.hpp"

namespace validate {

/// Margins of a map: gnuplot itself leaves too little for the labels of its colour bar.
std::string map_place(const Plot&, std::size_t panel);

/// Margins of a panel among rows of given shares; nothing for a plot without them.
std::string row_place(const Plot&, std::size_t panel);

/// Whether another panel stands below that has the x axis of both.
bool shares_axis_below(const Plot&, std::size_t panel);

/// The panel's letter, where there are several. Obliquely seen ones have no graph to place it by.
std::string letter(const Plot&, std::size_t panel, bool oblique);

/// The colour bar of an obliquely seen panel, which has no graph to stand beside.
std::string colour_box(const Plot&, std::size_t panel);

/// The caption's lines, below all panels.
std::string caption_commands(const Plot&);

/// The part of the drawing's height, from 0 to 1, that the caption takes.
double caption_share(const Plot&);

}  // namespace validate
