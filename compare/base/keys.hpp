// How a described member is called in a document: its name and its unit, and the twin in SI-like units.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <type_traits>

#include "compare/base/describe.hpp"
#include "compare/base/units.hpp"

namespace validate {

/// Name with the unit behind it: {"depth", Å} → "depth_A", {"depth-max", Å} → "depth_max_A".
std::string key(const Field& field);

/// The same quantity in another unit.
inline Field in_unit(Field field, std::string_view other) {
  field.unit = other;
  return field;
}

/// Calls emit(field, value) for each described member, and behind each membrane force in eV/Å² its twin in N/m; columns
/// have none.
template <class Struct, class Emit>
void describe_with_twins(const Struct& object, Emit&& emit) {
  describe(object, [&emit](const auto& field, const auto& value) {
    using Value = std::remove_cvref_t<decltype(value)>;
    emit(field, value);
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(field)>, Column>) {
      return;
    } else if constexpr (std::is_same_v<Value, double> || std::is_same_v<Value, std::optional<double>>) {
      if (field.unit != unit::membrane_force) return;
      std::optional<double> converted = value;
      if (converted) *converted *= N_per_m_per_eV_per_A2;
      emit(in_unit(field, unit::newton_per_metre), converted);
    } else if constexpr (std::is_same_v<Value, std::array<double, 2>>) {
      if (field.unit != unit::membrane_force) return;
      emit(in_unit(field, unit::newton_per_metre),
           Value{value[0] * N_per_m_per_eV_per_A2, value[1] * N_per_m_per_eV_per_A2});
    }
  });
}

}  // namespace validate
