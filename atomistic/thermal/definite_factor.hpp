// A Cholesky factor in double precision: its determinant, and solves.
#pragma once

#include <Eigen/CholmodSupport>
#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace atomistic {

/// Of symmetric matrices of one pattern, both triangles stored. By CHOLMOD, ordered by nested dissection.
class DefiniteFactor {
 public:
  /// The pattern is analysed with the first matrix. False if the matrix is not positive definite.
  bool factorise(const Eigen::SparseMatrix<double>& matrix);

  double log_determinant() const { return cholesky_.logDeterminant(); }
  Eigen::VectorXd solve(const Eigen::VectorXd& right_hand_side) const { return cholesky_.solve(right_hand_side); }

 private:
  using Cholesky = Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>, Eigen::Lower>;
  Cholesky cholesky_;
  bool analysed_ = false;
};

}  // namespace atomistic
