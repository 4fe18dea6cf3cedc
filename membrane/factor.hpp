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
  bool factorise(const Matrix& lower);

  /// The same for a matrix that is positive semi-definite (slack triangles leave nodes without stiffness):
  /// where needed, the identity times a shift is added, as little as serves.
  bool factorise_shifted(const Matrix& lower);

  /// Solution of (K + shift I) x = right_side.
  Eigen::VectorXd solve(const Eigen::VectorXd& right_side) const { return cholesky_.solve(right_side); }

  bool ready() const { return ready_; }
  double shift() const { return shift_; }  ///< eV/Å², 0 for a positive definite matrix
  int count() const { return count_; }     ///< factorisations so far

 private:
  bool attempt(const Matrix& lower, double shift);

  Eigen::CholmodSupernodalLLT<Matrix, Eigen::Lower> cholesky_;
  bool analysed_ = false;
  bool ready_ = false;
  double shift_ = 0;
  int count_ = 0;
};

}  // namespace membrane
