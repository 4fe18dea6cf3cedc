// Membranes solved for a figure, and the panels of figure 4's pressurised square.
#pragma once

#include <string>
#include <vector>

#include "compare/documents/plots/sheet_maps.hpp"
#include "compare/figures/paper_figure.hpp"
#include "compare/results/sheet_columns.hpp"

namespace validate {

/// Every level of a problem; throws std::runtime_error naming the figure where one is not solved.
std::vector<SheetPicture> solved_levels(const membrane::Problem& problem, double thickness_A, const char* figure);

/// How far the edges have come inwards, at most.
double largest_pull_in_A(const SheetPicture& square);

/// Where half of the triangles around are wrinkled, by area: strokes, one a triangle that the line crosses.
PlotCurve wrinkled_outline(const SheetPicture& square, SeenOver over);

/// A map's panel without its field.
Panel square_panel(const std::string& title, const char* label);

/// A column of the triangles over the flat square, named `key` in the data files, with the outline of the wrinkled
/// zone.
Panel square_panel(const std::string& title, const char* label, const SheetPicture& square, const std::string& column,
                   const std::string& key);

}  // namespace validate
