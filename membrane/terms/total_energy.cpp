#include "membrane/terms/total_energy.hpp"

#include <cmath>
#include <utility>

namespace membrane {
namespace {

NodePairs pairs_of(const std::vector<EnergyTerm*>& terms) {
  NodePairs pairs;
  for (const EnergyTerm* term : terms) term->couple(pairs);
  return pairs;
}

}  // namespace

TotalEnergy::TotalEnergy(Held held, std::vector<EnergyTerm*> terms)
    : held_(std::move(held)), terms_(std::move(terms)), hessian_(held_, pairs_of(terms_)) {
  for (EnergyTerm* term : terms_) term->locate(hessian_);
}

double TotalEnergy::energy(const Eigen::VectorXd& u, Eigen::VectorXd& gradient) {
  ++passes_;
  gradient.setZero(dof_count());
  double energy = 0;
  for (EnergyTerm* term : terms_) energy += term->add_gradient(u, gradient);
  return energy;
}

const Hessian::Matrix& TotalEnergy::hessian(const Eigen::VectorXd& u, double share) {
  ++passes_;
  hessian_.set_zero();
  for (EnergyTerm* term : terms_) term->add_hessian(u, share, hessian_);
  return hessian_.matrix();
}

double TotalEnergy::counted_from() const {
  double sum = 0;
  for (const EnergyTerm* term : terms_) sum += term->counted_from();
  return sum;
}

double TotalEnergy::part_norm() const {
  double squares = 0;
  for (const EnergyTerm* term : terms_) squares += term->part_norm() * term->part_norm();
  return std::sqrt(squares);
}

void TotalEnergy::release_held(Eigen::VectorXd& vector) const {
  for (std::size_t n = 0; n < held_.size(); ++n)
    for (int c = 0; c < 3; ++c)
      if (held_[n][c]) vector[3 * n + c] = 0;
}

}  // namespace membrane
