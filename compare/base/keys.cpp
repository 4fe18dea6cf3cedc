#include "compare/base/keys.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

namespace validate {

namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 20> suffixes = {{
    {unit::none, ""},
    {unit::length, "_A"},
    {unit::force, "_eV_per_A"},
    {unit::membrane_force, "_eV_per_A2"},
    {unit::stress, "_eV_per_A3"},
    {unit::energy, "_eV"},
    {unit::volume, "_A3"},
    {unit::newton_per_metre, "_N_per_m"},
    {unit::second, "_s"},
    {unit::nanometre, "_nm"},
    {unit::nanonewton, "_nN"},
    {unit::metre, "_m"},
    {unit::metre_per_volt, "_m_per_V"},
    {unit::metre_per_ampere, "_m_per_A"},
    {unit::metre_per_second, "_m_per_s"},
    {unit::volt, "_V"},
    {unit::hertz, "_Hz"},
    {unit::kelvin, "_K"},
    {unit::picosecond, "_ps"},
    {unit::share, ""},
}};

}  // namespace

std::string key(const Field& field) {
  const auto suffix = std::ranges::find(suffixes, field.unit, &std::pair<std::string_view, std::string_view>::first);
  if (suffix == suffixes.end()) throw std::logic_error("no suffix for the unit '" + std::string(field.unit) + "'");
  std::string name(field.name);
  std::ranges::replace(name, '-', '_');
  return name.append(suffix->second);
}

}  // namespace validate
