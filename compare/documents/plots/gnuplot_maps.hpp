// Maps of triangles as the rows between which gnuplot's pm3d fills.
#pragma once

#include <limits>
#include <string>

#include "compare/documents/plots/plot.hpp"

namespace validate {

/// The smallest and the largest of the finite values added.
struct DataRange {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
  void add(double value);
  bool known() const { return low <= high; }
};

/// Of the values of the panel's maps and coloured points.
DataRange range_of_values(const Panel&);

/// From which value to which the panel's colours go: the scale's own ends, else the values'.
DataRange coloured_range(const Panel&);

/// Two rows of points x, y, height, value, between which every piece is filled; what is between two pieces is open.
std::string map_rows(const Panel&, const TriangleMap&);

}  // namespace validate
