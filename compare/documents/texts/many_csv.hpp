// curves.csv of `validate fit`: one row a curve, in the units of a laboratory.
#pragma once

#include <string>
#include <string_view>

#include "compare/results/many.hpp"

namespace validate {

/// Names with units, without a line's end.
std::string many_csv_header();

/// One row, without a line's end; what is not known is an empty cell.
std::string many_csv_row(const CurveRow& row);

/// The row that made this line. Throws std::invalid_argument where it is none.
CurveRow many_csv_read(std::string_view line);

}  // namespace validate
