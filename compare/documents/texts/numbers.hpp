// Numbers as the tables for readers show them.
#pragma once

#include <string>

#include "compare/base/units.hpp"

namespace validate {

constexpr double in_N_per_m(double eV_per_A2) { return eV_per_A2 * N_per_m_per_eV_per_A2; }

/// A number by fmt's format for it: a dash where it is not known, and 0 instead of −0 for a rounding error of either
/// sign.
std::string number(double value, const char* format);

/// A membrane force or modulus in N/m with its error: "340.2 ± 0.3".
std::string with_error_N_per_m(double value_eV_per_A2, double error_eV_per_A2, int digits);

}  // namespace validate
