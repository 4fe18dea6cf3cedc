// Equilibrium of the meridian: Newton's method with a line search on the energy.
#pragma once

#include <Eigen/Core>
#include <string>

#include "membrane/meridian/assembly.hpp"
#include "membrane/meridian/block_tridiagonal.hpp"

namespace membrane::meridian {

struct Equilibrium {
  bool converged = false;
  std::string reason;            ///< empty when converged
  double force_eV_per_A = 0;     ///< multiplier of the pattern's depth; 0 without a pattern
  double relative_residual = 0;  ///< √(rᵀ K⁻¹ r / energy)
  int iterations = 0;
};

class Newton {
 public:
  explicit Newton(Assembly& assembly);

  /// Minimises the energy over x, in place. With a pattern its depth pattern·x stays what it is, and the
  /// force is the multiplier; an empty pattern leaves x free.
  Equilibrium solve(const Eigen::VectorXd& pattern, Eigen::VectorXd& x);

  int factorisations() const { return factorisations_; }

 private:
  bool factorise(const Eigen::VectorXd& x);
  bool move(Eigen::VectorXd& x);

  Assembly& assembly_;
  BlockTridiagonal hessian_;
  BlockCholesky factor_;
  int factorisations_ = 0;
  double energy_ = 0;
  Eigen::VectorXd gradient_, residual_, step_, trial_, trial_gradient_;
};

}  // namespace membrane::meridian
