// The table and the verdict on stdout.
#pragma once

#include <string>

#include "compare/documents/texts/text_table.hpp"
#include "compare/results/result.hpp"

namespace validate {

/// The verdict in a sentence, one row per run (fitted E·h and pretension with intervals, last force, how the path
/// ended), notes, what the plain membrane lacks; in lines of `width`, but of no more than 120 characters for sentences.
std::string table(const Result& result, int width = widest_line, bool colour = false);

/// Prints it; in colour on a terminal unless NO_COLOR is set.
void print_table(const Result& result);

}  // namespace validate
