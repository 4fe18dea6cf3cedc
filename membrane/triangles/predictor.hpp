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

/// How displacements begin along a path, as powers of its parameter: what is left after dividing by them is smooth.
struct Scaling {
  int in_plane = 2, transverse = 1;
};

/// A sheet pulled out of its plane from flat has u_z odd and u_x, u_y even in d, and without pretension u_z ~ d, u_xy ~
/// d² at small slopes.
inline constexpr Scaling from_flat{2, 1};
/// An edge moves: everything goes with the motion.
inline constexpr Scaling with_motion{1, 1};
/// The sheet is bulged before the path begins.
inline constexpr Scaling from_bulged{0, 0};

/// Extrapolates displacements in the conjugate depth d (or the multiple of a motion): the scaled displacements are
/// polynomials in d (Lagrange), which makes one earlier point a good guess and four an excellent one.
class Predictor {
 public:
  /// first_rotation: the first node that carries rotations, which go like what is transverse; −1: none does.
  explicit Predictor(Scaling scaling = from_flat, Eigen::Index first_rotation = -1)
      : scaling_(scaling), first_rotation_(first_rotation) {}

  void add(PathPoint point);

  bool empty() const { return points_.empty(); }
  std::size_t size() const { return points_.size(); }
  const PathPoint& last() const { return points_.back(); }

  /// Displacements at a conjugate depth; they have that depth exactly. Needs at least one point.
  Eigen::VectorXd displacements(double conjugate_depth_A) const;

  /// Conjugate depth at a force (on the meshed part): a parabola in log d over log F through the last two
  /// points with the last one's slope. Needs at least one point.
  double conjugate_depth(double force_eV_per_A) const;

 private:
  std::size_t points_that_reach(double conjugate_depth_A) const;

  Scaling scaling_;
  Eigen::Index first_rotation_;
  std::deque<PathPoint> points_;  ///< in the order of the path, no depth twice
};

}  // namespace membrane
