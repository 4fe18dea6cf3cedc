// The angle between two triangles that share an edge, with its derivatives.
#pragma once

#include <Eigen/Core>
#include <array>

namespace membrane {

/// Corners: the edge's start and end as the first triangle runs round it, the first triangle's third corner,
/// the second's.
using HingeCorners = std::array<Eigen::Vector3d, 4>;

/// Signed angle θ in (−π, π] by which the second triangle's normal leans towards the first's outer side:
/// positive where the surface is convex seen from the side of the normals.
double hinge_angle(const HingeCorners& corners);

/// By the corners, one after the other, 1/Å.
using HingeSlope = Eigen::Matrix<double, 12, 1>;
HingeSlope hinge_slope(const HingeCorners& corners);

struct Hinge {
  double angle = 0;
  HingeSlope gradient = HingeSlope::Zero();
  Eigen::Matrix<double, 12, 12> hessian = Eigen::Matrix<double, 12, 12>::Zero();  ///< symmetric, 1/Å²
};

/// ∂θ/∂x2 = −|e| N1/|N1|², N1 the cross product of the first triangle's edges, and likewise for x3; the
/// edge's ends follow since no rigid motion changes the angle. (Wardetzky et al., Comput. Aided Geom. Des. 24
/// (2007) 499; Tamstorf & Grinspun, Graph. Models 75 (2013) 362.)
Hinge hinge(const HingeCorners& corners);

}  // namespace membrane
