// One description per struct: name, unit, meaning and range of each member, visited by whatever reads or writes it:
// TOML, flags, --help, range errors, HDF5 (both ways), CSV, JSON and its schemas. A struct takes part through
//
//   void describe(SameStruct<Case> auto& self, auto&& visit) {
//     visit(Field{.name = "radius", .unit = unit::length, .meaning = "…", .range = positive()}, self.radius_A);
//     visit(Column{"depth", unit::length, "…"}, self.depth_A);
//     visit(Field{"fit", {}, "…"}, self.fit);
//   }
//
// so the same function serves reading (a Case) and writing (a const Case). A member is a value (number, truth
// value, text, enumerator with words), a list of values, a column, a described struct, an optional one, a list of them,
// or a variant of them, whose members then stand among those of the struct that holds it.
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
inline constexpr std::string_view nanometre = "nm";
inline constexpr std::string_view nanonewton = "nN";
inline constexpr std::string_view metre = "m";
inline constexpr std::string_view metre_per_volt = "m/V";
inline constexpr std::string_view metre_per_ampere = "m/A";
inline constexpr std::string_view metre_per_second = "m/s";
inline constexpr std::string_view volt = "V";
inline constexpr std::string_view hertz = "Hz";
inline constexpr std::string_view kelvin = "K";
inline constexpr std::string_view picosecond = "ps";
inline constexpr std::string_view share = "share";  ///< of something, 0 to 1
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
constexpr Range from_above_to(double low, double high) { return {low, high, true, false}; }
constexpr Range from_to(double low, double high) { return {low, high, false, false}; }

struct Field {
  std::string_view name;          ///< TOML key, flag (without --), JSON key, CSV header, HDF5 data set
  std::string_view unit = {};     ///< base unit of a number
  std::string_view meaning = {};  ///< one line for --help and for the attributes
  Range range = {};
  std::string_view table = {};                     ///< TOML table that holds the key; empty: top level
  std::span<const std::string_view> choices = {};  ///< allowed words of a text; empty: any text
  bool may_lack = false;                           ///< left out of documents where there is none
  bool top_too = false;                            ///< the key of a table may stand at the top level of a file too
  bool needs_unit = false;  ///< a number alone is refused: it is too easily meant in another unit

  constexpr Field where_known() const {
    Field field = *this;
    field.may_lack = true;
    return field;
  }
  constexpr Field with_unit() const {
    Field field = *this;
    field.needs_unit = true;
    return field;
  }
  constexpr Field at_top_too() const {
    Field field = *this;
    field.top_too = true;
    return field;
  }
};

/// A member with one value per point: all columns of a struct that are there are equally long.
struct Column : Field {
  constexpr Column where_known() const {
    Column column = *this;
    column.may_lack = true;
    return column;
  }
};

namespace detail {
struct AnyVisitor {
  template <class T>
  void operator()(const Field&, T&) const {}
};
}  // namespace detail

template <class Struct>
concept Described = std::is_class_v<Struct> && requires(const Struct& s) {
  describe(s, detail::AnyVisitor{});
};

}  // namespace validate
