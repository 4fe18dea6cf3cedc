// Where the next level's minimisation starts: extrapolation of the states before it.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace atomistic {

/// A converged state on the path: displacements of the free atoms at path parameter t. t grows like the depth
/// (the conjugate depth itself, or the cube root of the force).
struct PathState {
  double t = 0;
  Eigen::VectorXd displacement;
};

/// Extrapolates to t: from one state by scaling (in-plane ∝ t², out-of-plane ∝ t), from two by the secant,
/// from three by the parabola through them. States in the order of the path, the newest last.
Eigen::VectorXd extrapolate(const std::vector<PathState>& states, double t);

}  // namespace atomistic
