#include "membrane/triangles/predictor.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "membrane/triangles/tuning.hpp"

namespace membrane {

void Predictor::add(PathPoint point) {
  std::erase_if(points_, [&](const PathPoint& old) {  // coincident abscissae have no polynomial
    return std::abs(old.conjugate_depth_A - point.conjugate_depth_A) < 1e-6 * std::abs(point.conjugate_depth_A);
  });
  points_.push_back(std::move(point));
  if (points_.size() > PathTuning::most_points) points_.pop_front();
}

/// A polynomial reaches as far ahead as its points lie apart; beyond that one point is the better guide.
std::size_t Predictor::points_that_reach(double conjugate_depth_A) const {
  for (std::size_t count = points_.size(); count > 1; --count) {
    const auto [low, high] =
        std::minmax_element(points_.end() - count, points_.end(),
                            [](const auto& a, const auto& b) { return a.conjugate_depth_A < b.conjugate_depth_A; });
    const double span = high->conjugate_depth_A - low->conjugate_depth_A;
    const double ahead =
        std::max(conjugate_depth_A - high->conjugate_depth_A, low->conjugate_depth_A - conjugate_depth_A);
    if (ahead <= PathTuning::farthest * span) return count;
  }
  return 1;
}

Eigen::VectorXd Predictor::displacements(double conjugate_depth_A) const {
  Eigen::VectorXd u = Eigen::VectorXd::Zero(last().u.size());
  const Eigen::Index nodes = u.size() / 3;
  const Eigen::Index displaced = first_rotation_ < 0 ? nodes : first_rotation_;
  const auto first = points_.end() - points_that_reach(conjugate_depth_A);
  for (auto point = first; point != points_.end(); ++point) {
    double weight = 1;
    for (auto other = first; other != points_.end(); ++other)
      if (other != point)
        weight *=
            (conjugate_depth_A - other->conjugate_depth_A) / (point->conjugate_depth_A - other->conjugate_depth_A);
    const double ratio = conjugate_depth_A / point->conjugate_depth_A;
    const double in_plane = std::pow(ratio, scaling_.in_plane);
    const double transverse = std::pow(ratio, scaling_.transverse);
    const Eigen::Vector3d scale = weight * Eigen::Vector3d(in_plane, in_plane, transverse);
    u.reshaped(3, nodes).leftCols(displaced) += scale.asDiagonal() * point->u.reshaped(3, nodes).leftCols(displaced);
    const Eigen::Index rotations = 3 * (nodes - displaced);
    u.tail(rotations) += weight * transverse * point->u.tail(rotations);
  }
  return u;
}

double Predictor::conjugate_depth(double force_eV_per_A) const {
  const PathPoint& from = last();
  const double reach = std::log(force_eV_per_A / from.force_eV_per_A);
  const double known = from.compliance * from.force_eV_per_A / from.conjugate_depth_A;
  const double slope = known > 0 ? std::clamp(known, PathTuning::least_slope, PathTuning::most_slope) : 1.0 / 3;
  double curvature = 0;
  if (points_.size() > 1) {
    const PathPoint& before = *(points_.end() - 2);
    const double back = std::log(before.force_eV_per_A / from.force_eV_per_A);
    const double fall = std::log(before.conjugate_depth_A / from.conjugate_depth_A);
    if (std::abs(back) > 1e-6) curvature = (fall - slope * back) / (back * back);
  }
  const double bend = std::clamp(curvature * reach, -PathTuning::most_bend * slope, PathTuning::most_bend * slope);
  return from.conjugate_depth_A * std::exp((slope + bend) * reach);
}

}  // namespace membrane
