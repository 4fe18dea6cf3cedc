// What a member of a described struct can be, for the walks over the result tree.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "compare/base/describe.hpp"
#include "compare/base/words.hpp"

namespace validate {

template <class T>
struct is_optional : std::false_type {};
template <class T>
struct is_optional<std::optional<T>> : std::true_type {};

template <class T>
struct is_vector : std::false_type {};
template <class T>
struct is_vector<std::vector<T>> : std::true_type {};

template <class T>
struct is_variant : std::false_type {};
template <class... T>
struct is_variant<std::variant<T...>> : std::true_type {};

template <class T>
concept Optional = is_optional<T>::value;
template <class T>
concept Vector = is_vector<T>::value;
template <class T>
concept Variant = is_variant<T>::value;

/// Two numbers that belong together: the ends of a window or an interval.
using Pair = std::array<double, 2>;

/// Whether there is nothing in a member that may lack: no text, list or optional value, a number that is not known, a
/// struct with nothing in it.
inline bool lacks(double value) { return value != value; }
template <class T>
requires(std::is_integral_v<T> || std::is_enum_v<T>) bool lacks(T) { return false; }
inline bool lacks(const std::string& value) { return value.empty(); }
inline bool lacks(const Pair& value) { return lacks(value[0]) && lacks(value[1]); }
template <class T>
bool lacks(const std::optional<T>& value) {
  return !value;
}
template <class T>
bool lacks(const std::vector<T>& value) {
  return value.empty();
}
template <class T>
bool lacks(const std::shared_ptr<T>& value) {
  return !value;
}
template <class... T>
bool lacks(const std::variant<T...>&) {
  return false;
}
template <Described Struct>
bool lacks(const Struct& value) {
  bool nothing = true;
  describe(value, [&nothing](const Field&, const auto& member) { nothing = nothing && lacks(member); });
  return nothing;
}

}  // namespace validate
