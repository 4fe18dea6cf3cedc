// Where the next level's minimisation starts: extrapolation of the states before it.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace atomistic {

/// A converged state on the path: displacements of the free atoms at path parameter t. t grows like the depth
/// (the conjugate depth itself, or the cube root of the force).
struct PathState {
  double t = 0;
  Eigen::VectorXd displacement;
  std::optional<Eigen::VectorXd> guide;  ///< what a continuum had expected there
};

/// Extrapolates to t: from one state by scaling (in-plane ∝ t², out-of-plane ∝ t), from two by the secant,
/// from three by the parabola through them; over more than twenty of the last steps by scaling the newest. States in
/// the order of the path, the newest last.
Eigen::VectorXd extrapolate(const std::vector<PathState>& states, double t);

/// The continuum's expectation at t and the extrapolated rest of it, which is small and smooth. Where a state has no
/// guide, or there is none here, the states alone are extrapolated. No states, or none within twenty of the last steps:
/// the guide.
Eigen::VectorXd extrapolate(const std::vector<PathState>& states, double t,
                            const std::optional<Eigen::VectorXd>& guide);

}  // namespace atomistic
