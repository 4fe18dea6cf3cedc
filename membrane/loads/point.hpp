// A dead force at the centre.
#pragma once

#include "membrane/loads/setting.hpp"

namespace membrane {

/// Dead transverse force at the centre. On triangles it is on one node, and the depth depends on the mesh there;
/// without bending the slope is infinite, the depth finite.
struct PointLoad {
  void check(const LoadSetting& setting) const { setting.require_centre(); }
  CentreForce action() const { return {}; }
};

}  // namespace membrane
