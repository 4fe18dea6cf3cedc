// Every load. A new one is a file beside this one and a name here. It acts in one of the ways below; a new way is a
// name in Action, and nothing compiles until each discretisation says how it solves it, or that it cannot.
#pragma once

#include <variant>

#include "membrane/loads/action.hpp"
#include "membrane/loads/disc.hpp"
#include "membrane/loads/edge_motion.hpp"
#include "membrane/loads/point.hpp"
#include "membrane/loads/pressure.hpp"
#include "membrane/loads/radial.hpp"
#include "membrane/loads/sphere.hpp"

namespace membrane {

using Load = std::variant<PointLoad, DiscLoad, RadialLoad, SphereLoad, PressureLoad, EdgeMotion>;
using Action = std::variant<CentreForce, SpreadForce, RigidSphere, FollowerPressure, EdgeMotion>;

inline Action action_of(const Load& load) {
  return std::visit([]<LoadKind L>(const L& any) -> Action { return any.action(); }, load);
}

}  // namespace membrane
