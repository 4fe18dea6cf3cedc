// The softest vibrations of a Hessian: by inverse iteration, also where some eigenvalues are negative.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

namespace atomistic {

struct Eigenpairs {
  std::vector<double> values;            ///< rising, eV/Å²
  std::vector<Eigen::VectorXd> vectors;  ///< of length 1
};

/// The `count` lowest, to 1e-6 of themselves (of the shift that makes the matrix definite, where it is not), by a block
/// of inverse iterations with Rayleigh–Ritz projections, which finds equal eigenvalues too.
Eigenpairs lowest_modes(const Eigen::SparseMatrix<double>& hessian, int count);

}  // namespace atomistic
