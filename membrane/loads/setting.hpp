// What a load is asked and what it answers.
#pragma once

#include <cmath>
#include <concepts>

#include "membrane/base/refusal.hpp"
#include "membrane/loads/action.hpp"
#include "membrane/sheets/sheet.hpp"

namespace membrane {

/// What the levels prescribe: the load's displacement (depth, mean depth, motion) or its force (force,
/// pressure). A motion is always a displacement.
enum class Control { conjugate_depth, force };

/// What surrounds a load: a load is checked against it.
struct LoadSetting {
  const Sheet& sheet;
  Control control = Control::conjugate_depth;
  double pressure_eV_per_A3 = 0;  ///< beside the load
  double widest_patch_A = 0;      ///< of dead forces, as far as the discretisation bears them
  double widest_sphere_A = 0;

  /// Throws std::invalid_argument where nothing holds the sheet, or it has a hole where the load is.
  void require_centre() const {
    bool held = false;
    for (const auto& [edge, support] : supports_of(sheet)) held = held || support != Support::free;
    if (!held) refuse("sheet", "free edges", "some edge must be held, clamped or sliding: nothing bears the load");
    if (std::holds_alternative<AnnulusSheet>(sheet))
      refuse("load", "on the centre", "an annulus has no centre: move its hub instead");
  }

  /// Throws std::invalid_argument for a radius that is not positive or wider than the sheet can bear.
  static void require_radius(double radius_A, double widest_A) {
    if (!(radius_A > 0) || !std::isfinite(radius_A) || radius_A > widest_A)
      refuse("load.radius_A", radius_A,
             "must be positive and at most the sheet's radius or half its width (triangles: 0.98 of that)");
  }
};

/// Throws std::invalid_argument where an edge may leave the plane z = 0 under a pressure.
inline void require_closed(const Sheet& sheet, const char* member) {
  for (const auto& [edge, support] : supports_of(sheet))
    if (support == Support::free)
      refuse(member, "a pressure",
             "a sheet under pressure needs every edge in its plane: clamped or sliding, not free");
}

/// A load: whether it makes sense where it is (check() throws std::invalid_argument), and how it acts: one of
/// list.hpp's actions.
template <class L>
concept LoadKind = requires(const L& load, const LoadSetting& setting) {
  { load.check(setting) } -> std::same_as<void>;
  load.action();
};

}  // namespace membrane
