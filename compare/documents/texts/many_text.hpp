// What many curves say together, on the terminal.
#pragma once

#include <string>

#include "compare/results/many.hpp"

namespace validate {

/// Curves used and skipped by their reasons, means with their spread, the joint fit and what its error comes from.
std::string many_text(const ManyCurves& many);

}  // namespace validate
