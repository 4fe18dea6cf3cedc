// The table and the verdict on stdout.
#pragma once

#include <string>

#include "compare/results/result.hpp"

namespace validate {

/// At most 120 columns wide: one row per run (fitted E·h and pretension with standard errors, the card's E·h
/// beside them, quality of the fit, last force, how the path ended), notes, and the verdict in a sentence.
std::string table(const Result& result, bool colour = false);

/// Prints it; in colour on a terminal unless NO_COLOR is set.
void print_table(const Result& result);

}  // namespace validate
