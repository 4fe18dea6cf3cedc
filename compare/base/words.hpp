// The words that stand for the values of an enumerator type in files, flags, documents and tables. Each type has one
// list,
//
//   constexpr auto words(Model) { return std::array{Word{Model::membrane, "membrane"}, …}; }
//
// in the order of its values, and everything else follows from it: to_string, from_word, the choices of --help, the
// enumerations of the schemas. A list that lacks a value does not compile.
#pragma once

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string_view>
#include <type_traits>

namespace validate {

template <class Enum>
struct Word {
  Enum value;
  std::string_view name;
};

template <class Enum>
concept Worded = std::is_enum_v<Enum> && requires(Enum e) {
  words(e);
};

namespace detail {

/// Whether the type names this value: compilers print one that it does not name as a cast.
template <auto value>
constexpr bool is_named() {
  return std::string_view(__PRETTY_FUNCTION__).find("= (") == std::string_view::npos;
}

template <class Enum>
constexpr bool words_are_complete() {
  constexpr auto list = words(Enum{});
  for (std::size_t i = 0; i < list.size(); ++i)
    if (static_cast<std::size_t>(list[i].value) != i) return false;
  return !is_named<static_cast<Enum>(list.size())>();
}

}  // namespace detail

template <Worded Enum>
constexpr std::string_view to_string(Enum value) {
  static_assert(detail::words_are_complete<Enum>(),
                "the list of words lacks a value of the type, or changes their order");
  return words(value)[static_cast<std::size_t>(value)].name;
}

template <Worded Enum>
constexpr std::optional<Enum> from_word(std::string_view name) {
  for (const auto& word : words(Enum{}))
    if (word.name == name) return word.value;
  return std::nullopt;
}

/// All words of a type, in the order of its values.
template <Worded Enum>
inline constexpr auto all_words = [] {
  constexpr auto list = words(Enum{});
  std::array<std::string_view, list.size()> names;
  for (std::size_t i = 0; i < list.size(); ++i) names[i] = list[i].name;
  return names;
}();

}  // namespace validate

/// An enumerator is printed as its word.
template <validate::Worded Enum>
struct fmt::formatter<Enum> : fmt::formatter<std::string_view> {
  template <class Context>
  auto format(Enum value, Context& context) const {
    return fmt::formatter<std::string_view>::format(validate::to_string(value), context);
  }
};
