// Numbers of an instrument on the command line.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>

namespace validate {

/// A number > 0, alone in SI or with a unit that is a multiple of one of `units`; nothing for an empty text. Throws
/// Error (bad input) that names the flag, the units and the example.
std::optional<double> si_quantity(const std::string& text, std::initializer_list<const char*> units, const char* flag,
                                  const char* example);

}  // namespace validate
