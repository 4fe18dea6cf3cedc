// A batch as the terminal shows it.
#pragma once

#include <string>

#include "compare/documents/texts/text_table.hpp"
#include "compare/results/result.hpp"

namespace validate {

/// One row for each curve of atoms, or for a case that failed.
std::string batch_table(const Result& batch, int width = widest_line);

}  // namespace validate
