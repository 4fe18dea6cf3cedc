// Dead forces over a disc.
#pragma once

#include "membrane/loads/setting.hpp"

namespace membrane {

/// Dead transverse force, uniform per reference area over r <= radius_A.
struct DiscLoad {
  double radius_A = 0;

  void check(const LoadSetting& setting) const {
    setting.require_centre();
    LoadSetting::require_radius(radius_A, setting.widest_patch_A);
  }
  SpreadForce action() const {
    return {radius_A, [](double) { return 1.0; }};
  }
};

}  // namespace membrane
