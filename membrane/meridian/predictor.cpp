#include "membrane/meridian/predictor.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "membrane/meridian/hermite.hpp"
#include "membrane/meridian/tuning.hpp"

namespace membrane::meridian {

void Predictor::add(Known known) {
  if (last_ && std::abs(known.depth_A - last_->depth_A) > PathTuning::coincident * std::abs(known.depth_A))
    before_ = last_;
  last_ = std::move(known);
}

Eigen::VectorXd Predictor::scaled(const Known& from, double depth) const {
  if (!starts_flat_) return from.x;
  const double ratio = depth / from.depth_A;
  Eigen::VectorXd x = from.x;
  for (Eigen::Index dof = 0; dof < x.size(); ++dof) x[dof] *= dof % dofs_per_node < 2 ? ratio * ratio : ratio;
  return x;
}

Eigen::VectorXd Predictor::at(double depth) const {
  if (!last_) return depth * unit_;
  Eigen::VectorXd x = scaled(*last_, depth);
  const double ahead = depth - last_->depth_A;
  if (!before_) return starts_flat_ ? x : Eigen::VectorXd(x + ahead * unit_);
  const double share = ahead / (last_->depth_A - before_->depth_A);
  if (starts_flat_ && std::abs(share) > PathTuning::farthest) return x;
  return x + share * (x - scaled(*before_, depth));
}

double Predictor::depth_at(double force) const {
  double slope = 2;  // between a force that tilts (1) and one that stretches (3)
  if (before_ && before_->force_eV_per_A > 0 && last_->force_eV_per_A > 0)
    slope = std::log(last_->force_eV_per_A / before_->force_eV_per_A) / std::log(last_->depth_A / before_->depth_A);
  const double farther = std::log(force / last_->force_eV_per_A) / std::clamp(slope, 0.5, 10.0);
  return last_->depth_A * std::exp(std::clamp(farther, -2.0, 2.0));
}

}  // namespace membrane::meridian
