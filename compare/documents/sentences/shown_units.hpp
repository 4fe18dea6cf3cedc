// The units in which people are shown depths and forces: those in which they asked.
#pragma once

#include <string>

#include "compare/input/case.hpp"

namespace validate {

struct ShownUnit {
  std::string name;  ///< "nm"
  std::string key;   ///< in names of data: "nm", "eV_per_A"
  double in_base;    ///< one of it, in Å or eV/Å

  double of(double in_base_units) const { return in_base_units / in_base; }
  /// "12.11 Å", with four digits.
  std::string text(double in_base_units) const;
};

struct ShownUnits {
  ShownUnit length, force;
};

/// Å and eV/Å, or nm and nN where the case asks for laboratory units.
ShownUnits shown_units(const Case&);

}  // namespace validate
