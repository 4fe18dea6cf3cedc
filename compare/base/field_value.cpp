#include "compare/base/field_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
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

namespace {

/// What stands behind the number that a text begins with: its unit, or all of the text where there is no number.
std::string_view behind_number(std::string_view text) {
  const auto first = text.find_first_not_of(" +");
  if (first == std::string_view::npos) return {};
  text.remove_prefix(first);
  double number = 0;
  text.remove_prefix(
      static_cast<std::size_t>(std::from_chars(text.data(), text.data() + text.size(), number).ptr - text.data()));
  const auto unit = text.find_first_not_of(' ');
  return unit == std::string_view::npos ? std::string_view{} : text.substr(unit);
}

bool has_unit(std::string_view text) { return !behind_number(text).empty(); }

}  // namespace

double parse_number(const Field& field, std::string_view text, std::string_view label) {
  const double value = parse_quantity(text, field.unit, label);
  if (field.needs_unit && !has_unit(text)) refuse_without_unit(field, text, label);
  return in_range(field, value, label);
}

void refuse_without_unit(const Field& field, std::string_view number, std::string_view label) {
  throw bad_input("{}: '{}' has no unit; write one of {}", label, number, units_in_words(field.unit));
}

namespace {

/// The error's number, and its unit for a value that has none.
void share_unit(std::string& value, std::string& error) {
  if (!has_unit(value))
    value += behind_number(error);
  else if (!has_unit(error))
    error += behind_number(value);
}

}  // namespace

Uncertain parse_uncertain(const Field& field, std::string_view text, std::string_view label) {
  for (const std::string_view sign : {"±", "+/-", "+-"}) {
    const auto at = text.find(sign);
    if (at == std::string_view::npos) continue;
    std::string value(text.substr(0, at)), error(text.substr(at + sign.size()));
    Uncertain found;
    const Field share{field.name, unit::none, field.meaning, not_negative()};
    if (const auto percent = error.find('%'); percent != std::string::npos) {
      // "0.5 ± 2 % um": a unit behind the percent sign is the value's
      const double relative = parse_number(share, error.substr(0, percent), label) / 100;
      if (!has_unit(value)) value += error.substr(percent + 1);
      found.value = parse_number(field, value, label);
      found.error = relative * std::abs(found.value);
    } else {
      parse_quantity(error, field.unit, label);  // what is wrong with it is not to be told of the value
      share_unit(value, error);
      found.value = parse_number(field, value, label);
      found.error = parse_number(Field{field.name, field.unit, field.meaning, not_negative()}, error, label);
    }
    // A value that is larger by its error must be one, too.
    in_range(field, found.value + found.error, label);
    return found;
  }
  return {parse_number(field, text, label), 0};
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
