#include "compare/base/field_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "compare/base/errors.hpp"
#include "compare/base/nearest.hpp"
#include "compare/base/units.hpp"

namespace validate {

std::string label_of(const Origins& origins, std::string_view name) {
  const auto found = origins.find(name);
  return found != origins.end() ? found->second : std::string(name);
}

std::string describe_range(const Field& field) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto [low, high, low_open, high_open] = field.range;
  std::vector<std::string> bounds;
  if (low > -infinity) bounds.push_back(fmt::format("{} {}", low_open ? ">" : ">=", low));
  if (high < infinity) bounds.push_back(fmt::format("{} {}", high_open ? "<" : "<=", high));
  if (bounds.empty()) bounds.push_back("any finite number");
  return fmt::format("{}{}{}", fmt::join(bounds, " and "), field.unit.empty() ? "" : " ", field.unit);
}

double in_range(const Field& field, double value, std::string_view label) {
  if (field.range.contains(value)) return value;
  throw bad_input("{}: {}{}{} is not allowed; it must be {}", label, value, field.unit.empty() ? "" : " ", field.unit,
                  describe_range(field));
}

double parse_number(const Field& field, std::string_view text, std::string_view label) {
  return in_range(field, parse_quantity(text, field.unit, label), label);
}

std::string parse_text(const Field& field, std::string_view text, std::string_view label) {
  if (text.empty()) throw bad_input("{}: the text is empty; expected {}", label, field.meaning);
  const bool known = std::find(field.choices.begin(), field.choices.end(), text) != field.choices.end();
  if (!field.choices.empty() && !known) {
    throw bad_input("{}: '{}' is not known; allowed: {}{}", label, text, fmt::join(field.choices, ", "),
                    did_you_mean(text, field.choices));
  }
  return std::string(text);
}

}  // namespace validate
