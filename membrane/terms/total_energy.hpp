// The sum of a sheet's energies over all degrees of freedom, with one Hessian for all of them.
#pragma once

#include <vector>

#include "membrane/terms/term.hpp"

namespace membrane {

/// Counts its passes: they, and the factorisations, are what a solution costs.
class TotalEnergy {
 public:
  /// held: of all nodes, an indenter's included. The terms must couple nodes below held.size() only.
  TotalEnergy(Held held, std::vector<EnergyTerm*> terms);
  TotalEnergy(const TotalEnergy&) = delete;
  TotalEnergy& operator=(const TotalEnergy&) = delete;

  Eigen::Index dof_count() const { return 3 * static_cast<Eigen::Index>(held_.size()); }

  /// Energy (eV); gradient: dU/du (eV/Å), at held degrees of freedom the force that holds them.
  double energy(const Eigen::VectorXd& u, Eigen::VectorXd& gradient);

  /// Lower half of the Hessian with a share of its known negative curvature left out (EnergyTerm::add_hessian); held
  /// rows and columns are those of the unit matrix. Valid until the next call.
  const Hessian::Matrix& hessian(const Eigen::VectorXd& u, double share = 0);

  /// Root of the sum of squares of what the last energy() summed up into the gradient, eV/Å.
  double part_norm() const;

  /// Of all terms, EnergyTerm::counted_from().
  double counted_from() const;

  /// Sets held components to zero.
  void release_held(Eigen::VectorXd& vector) const;

  int passes() const { return passes_; }

 private:
  Held held_;
  std::vector<EnergyTerm*> terms_;
  Hessian hessian_;
  int passes_ = 0;
};

}  // namespace membrane
