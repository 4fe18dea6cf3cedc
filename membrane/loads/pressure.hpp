// A pressure whose values or volumes are the levels.
#pragma once

#include "membrane/loads/setting.hpp"

namespace membrane {

/// Follower pressure towards −z: levels are pressures, eV/Å³, or mean depths (volume under the sheet over its
/// area, Å). Edges must stay in the plane z = 0.
struct PressureLoad {
  void check(const LoadSetting& setting) const {
    require_closed(setting.sheet, "load");
    if (setting.pressure_eV_per_A3 != 0)
      refuse("pressure_eV_per_A3", setting.pressure_eV_per_A3, "must be 0 where the load is a pressure itself");
  }
  FollowerPressure action() const { return {}; }
};

}  // namespace membrane
