// Where each regime holds, in a sentence.
#pragma once

#include <string>

#include "compare/results/verdict.hpp"

namespace validate {

/// "bending up to 8.5 Å, bending and softening cancelling each other up to 14 Å, softening up to 29 Å"; the depths of a
/// comparison are in order. Empty without depths.
std::string regime_text(const Comparison& comparison);

}  // namespace validate
