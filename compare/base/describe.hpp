// One description per struct: name, unit, meaning and range of each field, visited by whatever reads or
// writes it (TOML, flags, --help, range errors, HDF5 attributes, CSV and JSON keys). A struct takes part
// through
//
//   template <class Self, class Visitor> requires SameStruct<Self, Case>
//   void describe(Self& self, Visitor&& visit) {
//     visit(Field{.name = "radius", .unit = unit::length, .meaning = "…", .range = positive()},
//     self.radius_A);
//   }
//
// so the same function serves reading (Self = Case) and writing (Self = const Case).
#pragma once

#include <limits>
#include <span>
#include <string_view>
#include <type_traits>

namespace validate {

template <class Self, class Struct>
concept SameStruct = std::is_same_v<std::remove_const_t<Self>, Struct>;

/// Names of the base units, as they appear in attributes and headers. units.hpp converts to and from them.
namespace unit {
inline constexpr std::string_view none = "";
inline constexpr std::string_view length = "Å";
inline constexpr std::string_view force = "eV/Å";
inline constexpr std::string_view membrane_force = "eV/Å²";
inline constexpr std::string_view stress = "eV/Å³";
inline constexpr std::string_view energy = "eV";
inline constexpr std::string_view volume = "Å³";
inline constexpr std::string_view newton_per_metre = "N/m";
inline constexpr std::string_view second = "s";
}  // namespace unit

/// Allowed values of a number. Written so that NaN never passes.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = true, high_open = true;

  constexpr bool contains(double x) const {
    return (low_open ? x > low : x >= low) && (high_open ? x < high : x <= high);
  }
};
constexpr Range any_number() { return {}; }
constexpr Range positive() { return {.low = 0}; }
constexpr Range not_negative() { return {.low = 0, .low_open = false}; }
constexpr Range between(double low, double high) { return {low, high, true, true}; }
constexpr Range from_to(double low, double high) { return {low, high, false, false}; }

struct Field {
  std::string_view name;          ///< TOML key, flag (without --), JSON key, CSV header, HDF5 data set
  std::string_view unit = {};     ///< base unit of a number
  std::string_view meaning = {};  ///< one line for --help and for the attributes
  Range range = {};
  std::string_view table = {};                     ///< TOML table that holds the key; empty: top level
  std::span<const std::string_view> choices = {};  ///< allowed words of a text; empty: any text
};

}  // namespace validate
