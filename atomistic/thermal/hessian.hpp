// The Hessian of a sheet's energy from differences of its gradient: atoms far enough apart are moved together.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <functional>
#include <vector>

#include "atomistic/lattice/sheet.hpp"

namespace atomistic {

/// ∂E/∂x of the free atoms, 3·free_atoms, at their positions.
using Gradient = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

/// Which free atoms are coupled, and which may be moved together: two atoms of one colour are coupled to no atom in
/// common, so that every difference of gradients is a sum of columns of which no two share a row (Curtis, Powell &
/// Reid, J. Inst. Maths Applics 13 (1974) 117).
class Coupling {
 public:
  /// Atoms up to `reach_bonds` bonds apart are coupled, held atoms between them included.
  Coupling(const Sheet& sheet, int reach_bonds);

  int atoms() const { return static_cast<int>(coupled_.size()); }
  int reach_bonds() const { return reach_bonds_; }
  int colours() const { return colours_; }
  int colour(int atom) const { return colour_[static_cast<std::size_t>(atom)]; }

  /// The free atoms coupled to this one, itself among them, in order.
  const std::vector<int>& coupled(int atom) const { return coupled_[static_cast<std::size_t>(atom)]; }

 private:
  int reach_bonds_, colours_ = 0;
  std::vector<std::vector<int>> coupled_;
  std::vector<int> colour_;
};

struct Hessian {
  Eigen::SparseMatrix<double> matrix;  ///< symmetric, both triangles, eV/Å²
  double asymmetry_relative = 0;       ///< ‖A − Aᵀ‖/‖A‖ of the differences before they were made symmetric
};

/// By central differences, 6 · colours gradients. Its error is of the order of difference_A².
Hessian hessian(const Gradient& gradient, const Coupling& coupling, const Eigen::VectorXd& positions,
                double difference_A = 1e-4);

/// ‖H v − Δg‖/‖H v‖ for a random direction v that moves every atom: what the pattern has missed. Two gradients.
double missed_by(const Hessian& hessian, const Gradient& gradient, const Eigen::VectorXd& positions,
                 double difference_A = 1e-4);

}  // namespace atomistic
