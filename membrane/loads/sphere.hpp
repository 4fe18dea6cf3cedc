// A spherical indenter.
#pragma once

#include "membrane/loads/setting.hpp"

namespace membrane {

/// Rigid frictionless sphere from above; its depth, that of its lowest point, is 0 where it touches the flat sheet.
struct SphereLoad {
  double radius_A = 0;

  void check(const LoadSetting& setting) const {
    setting.require_centre();
    if (!std::holds_alternative<DiscSheet>(setting.sheet)) refuse("load", "a sphere", "is implemented on discs only");
    LoadSetting::require_radius(radius_A, setting.widest_sphere_A);
  }
  RigidSphere action() const { return {radius_A}; }
};

}  // namespace membrane
