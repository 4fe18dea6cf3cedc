// Guesses the next equilibrium of a path from the last two.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <utility>

namespace membrane::meridian {

struct Known {
  double depth_A = 0;  ///< conjugate
  double force_eV_per_A = 0;
  Eigen::VectorXd x;
};

/// A sheet that starts flat has w odd and u even in the depth d: w/d and u/d² are what is extrapolated. With
/// a background pressure it does not start flat, and x itself is. Either way the guess has its depth exactly.
class Predictor {
 public:
  /// unit: a shape with a conjugate depth of one, to leave the first equilibrium with.
  Predictor(Eigen::VectorXd unit, bool starts_flat) : unit_(std::move(unit)), starts_flat_(starts_flat) {}

  void add(Known known);
  const Eigen::VectorXd& unit() const { return unit_; }
  const std::optional<Known>& last() const { return last_; }

  Eigen::VectorXd at(double depth_A) const;
  /// A depth for a force, from the slope in log force over log depth.
  double depth_at(double force_eV_per_A) const;

 private:
  Eigen::VectorXd scaled(const Known& from, double depth_A) const;

  Eigen::VectorXd unit_;
  bool starts_flat_;
  std::optional<Known> last_, before_;
};

}  // namespace membrane::meridian
