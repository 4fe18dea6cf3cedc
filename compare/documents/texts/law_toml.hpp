// A calibrated law as TOML, so that any finite-element code can use it.
#pragma once

#include <string>

#include "compare/potential/potential_card.hpp"

namespace validate {

/// Energy, coefficients, range, bending modulus and origin. The card must have a law.
std::string law_toml(const PotentialCard& card);

}  // namespace validate
