#include "compare/base/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <stdexcept>
#include <utility>
#include <vector>

#include "compare/base/describe.hpp"
#include "compare/base/errors.hpp"
#include "compare/base/nearest.hpp"

namespace validate {
namespace {

constexpr double nN = 1 / nN_per_eV_per_A;
constexpr double N_per_m = 1 / N_per_m_per_eV_per_A2;
constexpr double GPa = 1 / GPa_per_eV_per_A3;

constexpr std::array lengths = {Unit{"A", 1},    Unit{"pm", 1e-2}, Unit{"nm", 10},
                                Unit{"um", 1e4}, Unit{"mm", 1e7},  Unit{"m", 1e10}};
constexpr std::array forces = {Unit{"eV/A", 1},      Unit{"meV/A", 1e-3},  Unit{"pN", 1e-3 * nN}, Unit{"nN", nN},
                               Unit{"uN", 1e3 * nN}, Unit{"mN", 1e6 * nN}, Unit{"N", 1e9 * nN}};
constexpr std::array membrane_forces = {Unit{"eV/A^2", 1},
                                        Unit{"meV/A^2", 1e-3},
                                        Unit{"eV/nm^2", 1e-2},
                                        Unit{"uN/m", 1e-6 * N_per_m},
                                        Unit{"mN/m", 1e-3 * N_per_m},
                                        Unit{"N/m", N_per_m},
                                        Unit{"kN/m", 1e3 * N_per_m},
                                        Unit{"J/m^2", N_per_m}};
constexpr std::array stresses = {Unit{"eV/A^3", 1},         Unit{"eV/nm^3", 1e-3},   Unit{"Pa", 1e-9 * GPa},
                                 Unit{"N/m^2", 1e-9 * GPa}, Unit{"kPa", 1e-6 * GPa}, Unit{"MPa", 1e-3 * GPa},
                                 Unit{"GPa", GPa},          Unit{"TPa", 1e3 * GPa}};

constexpr std::array times = {Unit{"ps", 1}, Unit{"fs", 1e-3}, Unit{"ns", 1e3}};
constexpr std::array shares = {Unit{"share", 1}, Unit{"%", 1e-2}};
constexpr std::array temperatures = {Unit{"K", 1}, Unit{"mK", 1e-3}};

constexpr std::array<std::pair<std::string_view, Quantity>, 8> quantities = {{
    {unit::none, {"number", {}}},
    {unit::length, {"length", lengths}},
    {unit::force, {"force", forces}},
    {unit::membrane_force, {"membrane force", membrane_forces}},
    {unit::stress, {"stress", stresses}},
    {unit::kelvin, {"temperature", temperatures}},
    {unit::picosecond, {"time", times}},
    {unit::share, {"share", shares}},
}};

// Spellings that mean the same: both micro signs, both ångström signs and A with a combining ring, exponents.
constexpr std::array<std::pair<std::string_view, std::string_view>, 14> spellings = {{
    {"\u00b5", "u"},
    {"\u03bc", "u"},
    {"\u00c5", "A"},
    {"\u212b", "A"},
    {"A\u030a", "A"},
    {"Angstrom", "A"},
    {"angstrom", "A"},
    {"\u00b2", "^2"},
    {"\u00b3", "^3"},
    {"**", "^"},
    {" ", ""},
    {"\t", ""},
    {"\u00a0", ""},
    {"\u202f", ""},
}};

std::string plain_spelling(std::string_view text) {
  std::string plain(text);
  for (const auto& [from, to] : spellings) {
    for (auto at = plain.find(from); at != std::string::npos; at = plain.find(from, at + to.size())) {
      plain.replace(at, from.size(), to);
    }
  }
  return plain;
}

std::string_view trim(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string_view> unit_names(const Quantity& quantity) {
  std::vector<std::string_view> names;
  for (const Unit& u : quantity.units) names.push_back(u.name);
  return names;
}

struct NumberWithUnit {
  double number;
  std::string_view unit;  ///< empty: none written
};

NumberWithUnit split(std::string_view text, const Quantity& quantity, std::string_view label) {
  std::string_view rest = trim(text);
  if (rest.starts_with('+')) rest.remove_prefix(1);
  double number = 0;
  const auto [end, problem] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
  if (problem == std::errc::result_out_of_range) {
    throw bad_input("{}: '{}' is too large or too small for a number", label, text);
  }
  if (problem != std::errc{}) {
    const std::string_view hint = quantity.units.empty() ? "a number" : "a number, optionally with a unit";
    throw bad_input("{}: '{}' is not a {}; expected {}{}{}", label, text, quantity.name, hint,
                    quantity.units.empty() ? "" : ": ", fmt::join(unit_names(quantity), ", "));
  }
  return {number, trim(rest.substr(static_cast<std::size_t>(end - rest.data())))};
}

}  // namespace

const Quantity& quantity_of(std::string_view base_unit) {
  for (const auto& [base, quantity] : quantities) {
    if (base == base_unit) return quantity;
  }
  throw std::logic_error(fmt::format("no quantity is read in the unit '{}'", base_unit));
}

std::string units_in_words(std::string_view base_unit) {
  return fmt::format("{}", fmt::join(unit_names(quantity_of(base_unit)), ", "));
}

double parse_quantity(std::string_view text, std::string_view base_unit, std::string_view label) {
  const Quantity& quantity = quantity_of(base_unit);
  const auto [number, unit_text] = split(text, quantity, label);
  if (unit_text.empty()) return number;
  if (quantity.units.empty()) {
    throw bad_input("{}: '{}' must be a number without a unit (found '{}')", label, text, unit_text);
  }
  const std::string wanted = plain_spelling(unit_text);
  for (const Unit& u : quantity.units) {
    if (u.name == wanted) return number * u.in_base;
  }
  const auto names = unit_names(quantity);
  throw bad_input("{}: '{}' has the unknown unit '{}'; a {} takes {}{}", label, text, unit_text, quantity.name,
                  fmt::join(names, ", "), did_you_mean(wanted, names));
}

bool in_laboratory_units(std::string_view text) {
  double number = 0;
  const std::string_view rest = trim(text);
  const auto [end, problem] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
  if (problem != std::errc{}) return false;
  const std::string unit = plain_spelling(trim(rest.substr(static_cast<std::size_t>(end - rest.data()))));
  const auto is_it = [&](const Unit& u) { return u.name == unit && (u.name.ends_with('m') || u.name.ends_with('N')); };
  return unit != "pm" && (std::ranges::any_of(lengths, is_it) || std::ranges::any_of(forces, is_it));
}

}  // namespace validate
