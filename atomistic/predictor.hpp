// Where the next level's minimisation starts: extrapolation of the states before it.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "atomistic/sheet.hpp"

namespace atomistic {

/// A converged state on the path: displacements of the free atoms at path parameter t. t grows like the depth
/// (the conjugate depth itself, or the cube root of the force).
struct PathState {
  double t = 0;
  Eigen::VectorXd displacement;
};

/// Start for the first level: the clamped Föppl–von Kármán membrane under a central force,
/// w = depth (1 − (r/R)^{2/3}) (Schwerin), in-plane zero.
Eigen::VectorXd first_guess(const Sheet& sheet, double depth_A);

/// Extrapolates to t: from one state by scaling (in-plane ∝ t², out-of-plane ∝ t), from two by the secant,
/// from three by the parabola through them. States in the order of the path, the newest last.
Eigen::VectorXd extrapolate(const std::vector<PathState>& states, double t);

}  // namespace atomistic
