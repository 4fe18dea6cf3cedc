// Values of described fields as text: checks and messages that the case file and the flags share.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "compare/base/describe.hpp"
#include "compare/base/words.hpp"

namespace validate {

/// Where each given value came from, by field name: "case.toml:12: radius" or "--radius". Messages start with
/// it.
using Origins = std::map<std::string, std::string, std::less<>>;

/// The origin of a field's value, or only its name where the value is a default.
std::string label_of(const Origins&, std::string_view name);

/// The number itself if the field's range allows it, else Error (bad input). NaN and infinities never pass.
double in_range(const Field&, double value, std::string_view label);

/// Text with an optional unit → base units, in range. Throws Error (bad input) where the field needs a unit and there
/// is none.
double parse_number(const Field&, std::string_view text, std::string_view label);

/// Throws Error (bad input): the field takes no number without a unit.
[[noreturn]] void refuse_without_unit(const Field&, std::string_view number, std::string_view label);

/// A value and its standard error.
struct Uncertain {
  double value = 0, error = 0;
};

/// "0.50 ± 0.01 um", "0.5 um +- 2 %", or without an error → base units, the value in range, the error not negative. A
/// unit behind the error stands for both where the value has none.
Uncertain parse_uncertain(const Field&, std::string_view text, std::string_view label);

/// The text itself if it is one of the field's choices (or the field has none) and not empty.
std::string parse_text(const Field&, std::string_view text, std::string_view label);

/// The field with the words of an enumerator type as its choices.
template <Worded Enum>
Field with_words(Field field) {
  field.choices = all_words<Enum>;
  return field;
}

/// "> 0 Å", "> -1 and < 1"; "any finite number" without bounds.
std::string describe_range(const Field&);

}  // namespace validate
