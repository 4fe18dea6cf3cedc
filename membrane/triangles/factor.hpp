// The Cholesky factor of a tangent stiffness: one symbolic analysis per mesh.
#pragma once

#include <Eigen/CholmodSupport>
#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace membrane {

/// CHOLMOD's supernodal L Lᵀ behind Eigen.
class Factor {
 public:
  using Matrix = Eigen::SparseMatrix<double>;

  Factor();

  /// Factorises the lower half given; the first call analyses its pattern, which must not change later.
  /// Returns false if the matrix is not positive definite (or not finite); there is no factor then.
  /// `damping`: share of the largest diagonal entry that is added to the diagonal.
  bool factorise(const Matrix& lower, double damping = 0);

  /// The same with the least shift added that tells a singular matrix (slack triangles leave nodes without stiffness)
  /// from an indefinite one.
  bool factorise_singular(const Matrix& lower);

  /// Solution of (K + shift I) x = right_side.
  Eigen::VectorXd solve(const Eigen::VectorXd& right_side) const { return cholesky_.solve(right_side); }

  bool ready() const { return ready_; }
  int count() const { return count_; }  ///< factorisations so far

  /// Newton steps with an old factor (a solution and a pass over the sheet each) that cost about as much as a new one.
  int steps_worth() const;

 private:
  bool attempt(const Matrix& lower, double shift);

  mutable Eigen::CholmodSupernodalLLT<Matrix, Eigen::Lower> cholesky_;  // Eigen hands out its state only if not const
  bool analysed_ = false;
  bool ready_ = false;
  int count_ = 0;
};

}  // namespace membrane
