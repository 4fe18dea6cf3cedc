// Sheets under a pressure as the terminal shows them.
#pragma once

#include <string>

#include "compare/documents/texts/text_table.hpp"
#include "compare/results/result.hpp"

namespace validate {

/// A row per pressure of each membrane of triangles: depth, volume, wrinkled and slack area, stresses; and of the atoms
/// beside it. Empty where the case has no pressure.
std::string pressed_table(const Result& result, int width = widest_line);

}  // namespace validate
