// Where reference values come from, and whether they come from outside the code under verification.
#pragma once

#include <string>
#include <string_view>

#include "compare/results/checks.hpp"
#include "compare/verify/reference_numbers.hpp"

namespace validate::verify {

/// A number with its origin.
struct Reference {
  double value = 0;
  std::string origin;
  Basis basis = Basis::outside;
};

/// The answer as a formula, evaluated here; the text is the formula, with its source.
inline Reference closed_form(double value, std::string_view formula) {
  return {value, "closed form: " + std::string(formula), Basis::outside};
}

/// What the code owes to itself: balance, the order of an error, invariance, a bound that it sets.
inline Reference identity(double value, std::string_view what) {
  return {value, "identity: " + std::string(what), Basis::itself};
}

/// Computed with a code written separately, which is not part of this project's tests.
inline Reference separate_code(double value, std::string_view what) {
  return {value, "computed with a code written separately: " + std::string(what), Basis::outside};
}

/// A number of the table that tests/reference computes anew on every test run.
inline Reference tabulated(std::string_view name) {
  const reference::Number& number = reference::number(name);
  std::string origin(number.origin);
  constexpr std::string_view solver = "independent solver";
  if (origin.starts_with(solver)) origin.insert(solver.size(), " in tests/reference");
  return {number.value, origin, Basis::outside};
}

}  // namespace validate::verify
