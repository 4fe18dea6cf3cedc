// Guesses the next equilibrium of a path from the last ones.
#pragma once

#include <Eigen/Core>
#include <deque>

namespace membrane {

/// An equilibrium that the path has passed.
struct PathPoint {
  double conjugate_depth_A = 0;
  double force_eV_per_A = 0;  ///< on the meshed part
  double compliance = 0;      ///< dd/dF, Å²/eV
  Eigen::VectorXd u;          ///< displacements, Å
};

/// Extrapolates displacements in the conjugate depth d. A sheet that starts flat has u_z odd and u_x, u_y
/// even in d, and without pretension u_z ~ d, u_xy ~ d² at small slopes; so the smooth functions u_z/d and
/// u_xy/d² of d are what is extrapolated (Lagrange), which makes one earlier point a good guess and four an
/// excellent one.
class Predictor {
 public:
  void add(PathPoint point);

  bool empty() const { return points_.empty(); }
  const PathPoint& last() const { return points_.back(); }

  /// Displacements at a conjugate depth; they have that depth exactly. Needs at least one point.
  Eigen::VectorXd displacements(double conjugate_depth_A) const;

  /// Conjugate depth at a force (on the meshed part): a parabola in log d over log F through the last two
  /// points with the last one's slope. Needs at least one point.
  double conjugate_depth(double force_eV_per_A) const;

 private:
  std::deque<PathPoint> points_;  ///< in the order of the path, no depth twice
};

}  // namespace membrane
