#include "atomistic/thermal/modes.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "atomistic/thermal/definite_factor.hpp"

namespace atomistic {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;

namespace {

constexpr int guards = 6;  // more vectors than asked for: the convergence is by the ratio to the first that is left out
constexpr int most_iterations = 200;
constexpr double relative_accuracy = 1e-6;

MatrixXd random_block(Eigen::Index rows, Eigen::Index columns) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  return MatrixXd::NullaryExpr(rows, columns, [&] { return normal(random); });
}

/// Factorises H + shift with the smallest of the shifts 0, 1e-4, 4e-4, … that makes it definite.
double make_definite(const Matrix& hessian, DefiniteFactor& factor) {
  if (factor.factorise(hessian)) return 0;
  for (double shift = 1e-4; shift < 1e4; shift *= 4) {
    Matrix sum = hessian;
    sum.diagonal().array() += shift;
    if (factor.factorise(sum)) return shift;
  }
  throw std::runtime_error("a Hessian has eigenvalues beyond any that atoms have");
}

MatrixXd orthonormal(const MatrixXd& block) {
  return Eigen::HouseholderQR<MatrixXd>(block).householderQ() * MatrixXd::Identity(block.rows(), block.cols());
}

}  // namespace

Eigenpairs lowest_modes(const Matrix& hessian, int count) {
  DefiniteFactor factor;
  const double shift = make_definite(hessian, factor);
  const Eigen::Index size = std::min<Eigen::Index>(hessian.rows(), count + guards);
  MatrixXd block = orthonormal(random_block(hessian.rows(), size));
  VectorXd values = VectorXd::Zero(size);
  for (int i = 0; i < most_iterations; ++i) {
    for (Eigen::Index k = 0; k < size; ++k) block.col(k) = factor.solve(block.col(k));
    block = orthonormal(block);
    const MatrixXd projected = block.transpose() * (hessian * block);
    const Eigen::SelfAdjointEigenSolver<MatrixXd> ritz((projected + projected.transpose()) / 2);
    block = (block * ritz.eigenvectors()).eval();
    const VectorXd before = values;
    values = ritz.eigenvalues();
    const auto wanted = std::min<Eigen::Index>(count, size);
    const VectorXd scale = (values.array().abs() + shift).matrix();
    if (((values - before).array().abs() <= relative_accuracy * scale.array()).head(wanted).all()) break;
  }
  Eigenpairs pairs;
  for (Eigen::Index k = 0; k < std::min<Eigen::Index>(count, size); ++k) {
    pairs.values.push_back(values[k]);
    pairs.vectors.push_back(block.col(k));
  }
  return pairs;
}

}  // namespace atomistic
