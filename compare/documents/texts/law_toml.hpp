// A calibrated law as TOML, so that any finite-element code can use it.
#pragma once

#include <string>

#include "compare/results/result.hpp"

namespace validate {

/// Energy, coefficients, range, bending modulus and origin. The card must have a law.
std::string law_toml(const Result& card);

}  // namespace validate
