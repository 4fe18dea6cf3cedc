#include "compare/documents/sentences/shown_units.hpp"

#include <fmt/format.h>

#include "compare/base/units.hpp"

namespace validate {

std::string ShownUnit::text(double in_base_units) const { return fmt::format("{:.4g} {}", of(in_base_units), name); }

ShownUnits shown_units(const Case& c) {
  if (c.units == Units::laboratory) return {{"nm", "nm", 10}, {"nN", "nN", 1 / nN_per_eV_per_A}};
  return {{"Å", "A", 1}, {"eV/Å", "eV_per_A", 1}};
}

}  // namespace validate
