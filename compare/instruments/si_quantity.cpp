#include "compare/instruments/si_quantity.hpp"

#include <fmt/ranges.h>

#include <string_view>

#include "compare/base/errors.hpp"
#include "compare/instruments/text.hpp"

namespace validate {

std::optional<double> si_quantity(const std::string& text, std::initializer_list<const char*> units, const char* flag,
                                  const char* example) {
  if (text.empty()) return std::nullopt;
  const auto end = text.find_first_not_of("0123456789.+-eE");
  const auto number = number_of(std::string_view(text).substr(0, end));
  const auto unit = end == std::string::npos ? std::nullopt : si_unit(std::string_view(text).substr(end));
  bool fits = end == std::string::npos;
  for (const char* allowed : units) fits = fits || (unit && unit->unit == allowed);
  if (!number || !fits || !(*number > 0))
    throw bad_input("{}: '{}' is not a number > 0 in {}, such as \"{}\"", flag, printable(text),
                    fmt::join(units, " or "), example);
  return *number * (unit ? unit->factor : 1);
}

}  // namespace validate
