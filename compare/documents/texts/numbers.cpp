#include "compare/documents/texts/numbers.hpp"

#include <fmt/format.h>

#include <cmath>

namespace validate {

std::string number(double value, const char* format) {
  if (!std::isfinite(value)) return "–";
  const std::string text = fmt::format(fmt::runtime(format), value);
  const bool zero = text.find_first_not_of("-0.") == std::string::npos;
  return zero ? fmt::format(fmt::runtime(format), 0.0) : text;
}

std::string with_error_N_per_m(double value_eV_per_A2, double error_eV_per_A2, int digits) {
  const std::string format = fmt::format("{{:.{}f}}", digits);
  return number(in_N_per_m(value_eV_per_A2), format.c_str()) + " ± " +
         number(in_N_per_m(error_eV_per_A2), format.c_str());
}

}  // namespace validate
