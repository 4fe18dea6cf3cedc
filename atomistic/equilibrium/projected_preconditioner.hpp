// P⁻¹ on the subspace that a linear constraint leaves, for every minimiser.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "atomistic/equilibrium/minimiser.hpp"

namespace atomistic {

/// P⁻¹ on the subspace c·s = 0, and the multiplier that belongs to it: λ = cᵀP⁻¹g / cᵀP⁻¹c.
class ProjectedPreconditioner {
 public:
  explicit ProjectedPreconditioner(const Minimisation& problem) : problem_(problem) {
    if (problem_.constraint.size() == 0) return;
    direction_ =
        problem_.constraint_response.size() ? problem_.constraint_response : problem_.precondition(problem_.constraint);
    stiffness_ = dot(problem_.constraint, direction_);
  }

  Eigen::VectorXd operator()(const Eigen::VectorXd& g) const {
    Eigen::VectorXd s = problem_.precondition(g);
    project(s);
    return s;
  }

  /// Removes what leaves the subspace, along P⁻¹c.
  void project(Eigen::VectorXd& s) const {
    if (constrained()) s -= direction_ * (dot(problem_.constraint, s) / stiffness_);
  }

  double multiplier(const Eigen::VectorXd& g) const { return constrained() ? dot(direction_, g) / stiffness_ : 0.0; }

  Eigen::VectorXd without_load(const Eigen::VectorXd& g) const {
    return constrained() ? Eigen::VectorXd(g - multiplier(g) * problem_.constraint) : g;
  }

 private:
  double dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const { return problem_.dot(a, b); }
  bool constrained() const { return direction_.size() > 0; }

  const Minimisation& problem_;
  Eigen::VectorXd direction_;
  double stiffness_ = 0;
};

inline double largest_atom_norm(const Eigen::VectorXd& v, const Team& team) {
  return team.largest(
      v.size() ? Eigen::Map<const Eigen::Matrix3Xd>(v.data(), 3, v.size() / 3).colwise().norm().maxCoeff() : 0.0);
}

/// The energy is a sum over thousands of atoms: differences below this are rounding (AIREBO: some 1e-12 of
/// the sum).
inline double rounding_floor(double energy) { return 1e-11 * std::max(1.0, std::abs(energy)); }

}  // namespace atomistic
