#include "membrane/triangles/softest.hpp"

#include <cmath>
#include <limits>

#include "membrane/triangles/tuning.hpp"

namespace membrane {
namespace {

using Eigen::VectorXd;

/// The smallest shift, a share of the tangent's largest diagonal entry, with which it is positive definite.
double shift_for(Factor& factor, const Hessian::Matrix& tangent) {
  for (double share = SoftestTuning::first_shift; share <= SoftestTuning::most_shift;
       share *= SoftestTuning::shift_growth)
    if (factor.factorise(tangent, share)) return share;
  return std::numeric_limits<double>::quiet_NaN();
}

/// Without a direction of its own the start has some of every one.
VectorXd scattered(Eigen::Index size) {
  VectorXd v(size);
  double x = 0.37;
  for (double& component : v) {
    x = std::fmod(997.3 * x + 0.1234, 1.0);
    component = x - 0.5;
  }
  return v;
}

}  // namespace

Softest softest(TotalEnergy& energy, Factor& factor, const VectorXd& u, const VectorXd& held) {
  const Hessian::Matrix& tangent = energy.hessian(u);
  Softest found;
  if (!std::isfinite(shift_for(factor, tangent))) {
    found.stiffness_eV_per_A2 = std::numeric_limits<double>::quiet_NaN();
    return found;
  }
  const bool constrained = held.squaredNorm() > 0;
  const VectorXd response = constrained ? VectorXd(factor.solve(held)) : VectorXd();
  VectorXd v = scattered(u.size());
  energy.release_held(v);
  for (int i = 0; i < SoftestTuning::iterations; ++i) {
    v = factor.solve(v);
    energy.release_held(v);
    if (constrained) v -= (held.dot(v) / held.dot(response)) * response;
    v.normalize();
  }
  found.stiffness_eV_per_A2 = v.dot(tangent.selfadjointView<Eigen::Lower>() * v);
  found.shape = std::move(v);
  return found;
}

bool step_off(TotalEnergy& energy, const Softest& direction, double smallest_A, VectorXd& u) {
  VectorXd unused;
  const double start = energy.energy(u, unused), largest = direction.shape.cwiseAbs().maxCoeff();
  VectorXd best = u;
  double least = start;
  for (const double side : {1.0, -1.0}) {
    double before = start;
    for (double step = side * smallest_A / largest;; step *= 2) {
      const VectorXd trial = u + step * direction.shape;
      const double there = energy.energy(trial, unused);
      if (!(there < before)) break;
      before = there;
      if (there < least) least = there, best = trial;
    }
  }
  if (!(least < start)) return false;
  u = std::move(best);
  return true;
}

}  // namespace membrane
