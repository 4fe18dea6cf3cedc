#include "membrane/bending/hinge.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace membrane {
namespace {

using Rows = Eigen::Matrix<double, 3, 12>;  // derivative of a vector by the four corners
using Row = Eigen::Matrix<double, 1, 12>;

Eigen::Matrix3d cross_with(const Eigen::Vector3d& v) {
  return Eigen::Matrix3d{{0, -v[2], v[1]}, {v[2], 0, -v[0]}, {-v[1], v[0], 0}};
}

/// Derivative of the difference of two corners.
Rows difference(int to, int from) {
  Rows d = Rows::Zero();
  d.middleCols<3>(3 * to) += Eigen::Matrix3d::Identity();
  d.middleCols<3>(3 * from) -= Eigen::Matrix3d::Identity();
  return d;
}

/// A third corner: where it is along the edge (0 at its start, 1 at its end), and ∂θ/∂corner = −|e| N/|N|².
struct Wing {
  Eigen::Vector3d e, v, N;
  double along;
  Eigen::Vector3d slope;

  Wing(const HingeCorners& x, int corner, double side)
      : e(x[1] - x[0]),
        v(x[corner] - x[0]),
        N(side * e.cross(v)),
        along(v.dot(e) / e.squaredNorm()),
        slope(-e.norm() / N.squaredNorm() * N) {}
};

/// The derivatives of both.
struct WingRates {
  Row along;
  Rows slope;

  WingRates(const Wing& at, int corner, double side) {
    const Rows de = difference(1, 0);
    const Rows dv = difference(corner, 0);
    const double e2 = at.e.squaredNorm();
    const double N2 = at.N.squaredNorm();
    const double length = std::sqrt(e2);
    along = (at.v.transpose() * de + at.e.transpose() * dv - 2 * at.along * at.e.transpose() * de) / e2;
    const Rows dN = side * (cross_with(at.e) * dv - cross_with(at.v) * de);
    slope =
        -length / N2 * (dN - 2 / N2 * at.N * (at.N.transpose() * dN)) - at.N / N2 * (at.e.transpose() * de) / length;
  }
};

HingeSlope slope_of(const Wing& first, const Wing& second) {
  HingeSlope slope;
  slope << -(1 - first.along) * first.slope - (1 - second.along) * second.slope,
      -first.along * first.slope - second.along * second.slope, first.slope, second.slope;
  return slope;
}

}  // namespace

double hinge_angle(const HingeCorners& x) {
  const Eigen::Vector3d e = x[1] - x[0];
  const Eigen::Vector3d n1 = e.cross(x[2] - x[0]);
  const Eigen::Vector3d n2 = (x[3] - x[0]).cross(e);
  return std::atan2(n1.cross(n2).dot(e.normalized()), n1.dot(n2));
}

HingeSlope hinge_slope(const HingeCorners& x) { return slope_of(Wing(x, 2, 1), Wing(x, 3, -1)); }

Hinge hinge(const HingeCorners& x) {
  const Wing first(x, 2, 1);
  const Wing second(x, 3, -1);
  const WingRates d_first(first, 2, 1);
  const WingRates d_second(second, 3, -1);
  Hinge at;
  at.angle = hinge_angle(x);
  at.gradient = slope_of(first, second);
  at.hessian.middleRows<3>(6) = d_first.slope;
  at.hessian.middleRows<3>(9) = d_second.slope;
  at.hessian.middleRows<3>(3) = -first.along * d_first.slope - first.slope * d_first.along -
                                second.along * d_second.slope - second.slope * d_second.along;
  at.hessian.topRows<3>() = -at.hessian.middleRows<3>(3) - d_first.slope - d_second.slope;
  return at;
}

}  // namespace membrane
