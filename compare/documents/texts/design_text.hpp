// What a planned experiment will tell, as a table.
#pragma once

#include <string>

#include "compare/results/design.hpp"

namespace validate {

std::string design_text(const Design& design);

}  // namespace validate
