// A sheet whose rim is pulled, as the terminal shows it.
#pragma once

#include <string>

#include "compare/documents/texts/text_table.hpp"
#include "compare/results/result.hpp"

namespace validate {

/// A row per depth of each curve: force, force over that of the cone under a point, where it is wrinkled or bears
/// compression; and what the closed forms say. Empty where no rim is pulled.
std::string pulled_rim_table(const Result& result, int width = widest_line);

}  // namespace validate
