// How a load acts on a sheet: what the solvers know of loads. Each discretisation answers for every one of these.
#pragma once

#include <functional>

namespace membrane {

/// A dead force at the centre alone.
struct CentreForce {};

/// Dead forces of a relative density per reference area (only ratios count) over r <= radius_A.
struct SpreadForce {
  double radius_A = 0;
  std::function<double(double r_A)> density;
};

/// A rigid frictionless sphere that comes from above.
struct RigidSphere {
  double radius_A = 0;
};

/// A follower pressure towards −z is the load itself.
struct FollowerPressure {};

}  // namespace membrane
