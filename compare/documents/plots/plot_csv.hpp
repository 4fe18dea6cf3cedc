// What is drawn, as a table.
#pragma once

#include <string>

#include "compare/documents/plots/plot.hpp"

namespace validate {

/// Whether the corners of a map's triangles are in the table, beside their centroids.
enum class Corners { left_out, written };

/// One row a point: panel, curve, x_key, y_key, x, y, upper_or_value, and with corners x1_A, y1_A, … of the triangles.
/// Keys have the units; the last of the seven is the upper edge of a band, the value of a coloured point, or that of a
/// map's triangle whose centroid is x, y. Points that are not finite, and so not drawn, are left out.
std::string plot_rows(const Plot& plot, Corners corners);

/// The table of a run folder: title and axes in `#` lines, then the rows. Maps of more than 20000 triangles in all are
/// left to `fields_in`, which the header says.
std::string plot_csv(const Plot& plot, const std::string& fields_in);

}  // namespace validate
