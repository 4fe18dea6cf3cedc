#include "atomistic/thermal/definite_factor.hpp"

#include <new>

namespace atomistic {

bool DefiniteFactor::factorise(const Eigen::SparseMatrix<double>& matrix) {
  if (!analysed_) {
    cholesky_.cholmod().nmethods = 1;
    cholesky_.cholmod().method[0].ordering = CHOLMOD_METIS;
    cholesky_.cholmod().postorder = 1;
    cholesky_.cholmod().print = 0;
    cholesky_.analyzePattern(matrix);
    analysed_ = true;
  }
  cholesky_.factorize(matrix);
  if (cholesky_.cholmod().status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
  return cholesky_.info() == Eigen::Success;
}

}  // namespace atomistic
