// What the plain membrane lacks, as the terminal shows it.
#pragma once

#include <string>

#include "compare/documents/texts/text_table.hpp"
#include "compare/results/result.hpp"

namespace validate {

/// One block per load: shares in per cent of the plain membrane's force, and the atoms over each continuum. Empty
/// without calibrated curves.
std::string explanation_text(const Result& result, int width = widest_line);

}  // namespace validate
