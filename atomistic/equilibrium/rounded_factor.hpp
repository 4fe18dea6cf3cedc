// A Cholesky factor in single precision, for solves at half the memory traffic.
#pragma once

#include <Eigen/CholmodSupport>
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

namespace atomistic {

/// A = Pᵀ L Lᵀ P by CHOLMOD in double precision; L is then rounded to single. L̃ L̃ᵀ is symmetric positive definite
/// whatever the rounding, and solve() applies its inverse in double precision: as a preconditioner it differs from A by
/// 1e-7 of A's entries at random, which smooth soft modes average out. A solve reads the whole factor twice, so that
/// its time is that of the memory: half of it saved. The single numbers take the place of the double ones.
/// Indices have 64 bits: a sheet of two million atoms has more numbers in its factor than 32 can count.
class RoundedFactor
    : private Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double, Eigen::ColMajor, SuiteSparse_long>,
                                          Eigen::Lower> {
 public:
  using Index = SuiteSparse_long;
  using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, Index>;

  /// Orders by nested dissection (METIS), which for sheets needs a third fewer operations than CHOLMOD's first choice.
  RoundedFactor();

  /// Throws std::bad_alloc where there is no room, as factorise() does.
  void analyse(const Matrix& lower);

  /// False if the matrix is not positive definite.
  bool factorise(const Matrix& lower);

  Eigen::VectorXd solve(const Eigen::VectorXd& right_hand_side) const;

 private:
  void require_success();
  void forward(double* x) const;
  void backward(double* x) const;

  const float* values() const { return static_cast<const float*>(m_cholmodFactor->x); }

  std::vector<double> inverse_diagonal_;
  mutable std::vector<double> work_;  ///< one supernode's rows
};

}  // namespace atomistic
