// Units at the border of the program: text to base units (Å, eV/Å, eV/Å², eV/Å³) and factors for output. This
// is the only place that holds a conversion factor.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace validate {

// From the elementary charge, exact since 2019 (CODATA): 1 eV = 1.602176634e-19 J.
inline constexpr double nN_per_eV_per_A = 1.602176634;                 ///< 1 eV/Å in nN
inline constexpr double N_per_m_per_eV_per_A2 = 10 * nN_per_eV_per_A;  ///< 1 eV/Å² in N/m
inline constexpr double GPa_per_eV_per_A3 = 100 * nN_per_eV_per_A;     ///< 1 eV/Å³ in GPa

struct Unit {
  std::string_view name;  ///< plain spelling: A, um, eV/A^2
  double in_base;         ///< one of it, in the base unit
};

/// A physical quantity with the units that are understood, the base unit first. A pure number has no units.
struct Quantity {
  std::string_view name;  ///< "length", for messages
  std::span<const Unit> units;
};

/// The quantity measured in a base unit of describe.hpp's `unit`. Throws std::logic_error for any other text.
const Quantity& quantity_of(std::string_view base_unit);

/// "eV/A^2, meV/A^2, …": the units that are understood beside a base unit, for messages.
std::string units_in_words(std::string_view base_unit);

/// "110", "11 nm", "0.34 N/m" → base units. A number without a unit is in base units. Also understood: Å for
/// A, µ for u, ² and ** for ^2. Throws Error (bad input) whose message starts with `label` (file, line and
/// key, or flag) and names the text, the units allowed and the nearest one. nan and inf are numbers here:
/// ranges refuse them.
double parse_quantity(std::string_view text, std::string_view base_unit, std::string_view label);

/// Whether a text is a length or a force in units of a laboratory (nm and up, pN and up), not in Å or eV/Å.
bool in_laboratory_units(std::string_view text);

}  // namespace validate
