// Cubic Hermite elements on a meridian: displacement outward u and depth w, both with continuous slope.
#pragma once

#include <Eigen/Core>

namespace membrane::meridian {

/// At one point of the meridian: [u, u', u'', w, w', w''], primes along the reference radius.
using LocalState = Eigen::Matrix<double, 6, 1>;
enum : int { U, U1, U2, W, W1, W2 };

/// Of one node: [u, u', w, w'].
inline constexpr int dofs_per_node = 4;

/// Takes the eight degrees of freedom of an element to the local state at one of its points.
using Interpolation = Eigen::Matrix<double, 6, 2 * dofs_per_node>;

/// On an element of this length, at a share t in [0, 1] of it.
inline Interpolation interpolation(double length, double t) {
  // Rows: value, first and second derivative; columns: value and slope at the start, then at the end.
  Eigen::Matrix<double, 3, 4> h;
  h << 1 - t * t * (3 - 2 * t), length * t * (1 - t) * (1 - t), t * t * (3 - 2 * t),
      length * t * t * (t - 1),                                                                     //
      -6 * t * (1 - t) / length, (1 - t) * (1 - 3 * t), 6 * t * (1 - t) / length, t * (3 * t - 2),  //
      (12 * t - 6) / (length * length), (6 * t - 4) / length, (6 - 12 * t) / (length * length), (6 * t - 2) / length;
  Interpolation B = Interpolation::Zero();
  for (int node = 0; node < 2; ++node) {
    B.block<3, 2>(U, dofs_per_node * node) = h.middleCols<2>(2 * node);
    B.block<3, 2>(W, dofs_per_node * node + 2) = h.middleCols<2>(2 * node);
  }
  return B;
}

}  // namespace membrane::meridian
