#include "atomistic/cell/homogeneous_cell.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace atomistic {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::VectorXd;

constexpr double half_height_A = 20;

double Supercell::area() const { return along_x * along_y * a * a * std::numbers::sqrt3; }

VectorXd Supercell::positions() const {
  const double b = std::numbers::sqrt3 * a;
  // bonds along y: each pair (0, 1) and (2, 3) is one of them
  const double basis[4][2] = {{0, 0}, {0, 1.0 / 3}, {0.5, 0.5}, {0.5, 5.0 / 6}};
  VectorXd x(3 * atoms());
  int k = 0;
  for (int i = 0; i < along_x; ++i)
    for (int j = 0; j < along_y; ++j)
      for (const auto& [u, v] : basis) x.segment<3>(3 * k++) << a * (i + u), b * (j + v), 0.0;
  return x;
}

Box Supercell::box(const Matrix2d& f) const {
  return {.low = {0, 0, -half_height_A},
          .high = {f(0, 0) * along_x * a, f(1, 1) * along_y * std::numbers::sqrt3 * a, half_height_A},
          .tilt_xy = f(0, 1) * along_y * std::numbers::sqrt3 * a,
          .periodic = true};
}

HomogeneousCell::HomogeneousCell(const Potential& potential, const Supercell& cell, const std::string& log_file)
    : cell_(cell), flat_(cell.positions()), forces_(potential, cell.box(), flat_, log_file) {}

Matrix2d HomogeneousCell::affine(const Matrix2d& f) {
  forces_.set_box(cell_.box(f));
  shift_.setZero();
  evaluate(f);
  return forces_.membrane_force();
}

Matrix2d HomogeneousCell::relaxed(const Matrix2d& f, bool from_last) {
  forces_.set_box(cell_.box(f));
  if (!from_last) shift_.setZero();
  Vector2d residual = evaluate(f);
  Matrix2d stiffness = shift_stiffness(f, residual);
  const double enough = 1e-11 * stiffness.norm();
  residual = evaluate(f);  // the stiffness has left a displaced state behind
  for (int i = 0; i < 30 && residual.norm() > enough; ++i) {
    Vector2d step = stiffness.inverse() * residual;
    if (step.norm() > 0.1) step *= 0.1 / step.norm();
    shift_ += step;
    const double before = residual.norm();
    residual = evaluate(f);
    if (residual.norm() > 0.1 * before && residual.norm() > 1e3 * enough) {
      stiffness = shift_stiffness(f, residual);
      evaluate(f);
    }
  }
  in_balance_ = residual.norm() <= 1e3 * enough;
  return forces_.membrane_force();
}

/// An atom at the origin of sublattice 0 and its three neighbours.
double HomogeneousCell::longest_bond(const Matrix2d& f) const {
  const double l = cell_.a / std::numbers::sqrt3;
  const Vector2d bonds[] = {{0, l}, {cell_.a / 2, -l / 2}, {-cell_.a / 2, -l / 2}};
  double longest = 0;
  for (const Vector2d& bond : bonds) longest = std::max(longest, (f * bond + shift_).norm());
  return longest;
}

bool HomogeneousCell::stable(const Matrix2d& f) {
  const double energy = energy_;
  const Matrix2d stiffness = shift_stiffness(f, evaluate(f));
  evaluate(f);  // the stiffness has left a displaced state behind
  energy_ = energy;
  return Eigen::SelfAdjointEigenSolver<Matrix2d>(stiffness).eigenvalues()[0] > 0;
}

/// Mean in-plane force on an atom of sublattice 1.
Vector2d HomogeneousCell::evaluate(const Matrix2d& f) {
  VectorXd x = flat_;
  for (int i = 0; i < cell_.atoms(); ++i)
    x.segment<2>(3 * i) = f * flat_.segment<2>(3 * i) + Supercell::sublattice(i) * shift_;
  energy_ = forces_.evaluate(x, atom_forces_);
  Vector2d mean = Vector2d::Zero();
  for (int i = 0; i < cell_.atoms(); ++i)
    if (Supercell::sublattice(i) == 1) mean += atom_forces_.segment<2>(3 * i);
  return mean / (cell_.atoms() / 2.0);
}

Matrix2d HomogeneousCell::shift_stiffness(const Matrix2d& f, const Vector2d& at_rest) {
  constexpr double small = 1e-4;
  const Vector2d here = shift_;
  Matrix2d k;
  for (int c : {0, 1}) {
    shift_ = here + small * Vector2d::Unit(c);
    k.col(c) = (at_rest - evaluate(f)) / small;
  }
  shift_ = here;
  return k;
}

Matrix2d gradient_of_strain(const Matrix2d& strain) {
  const Matrix2d c = Matrix2d::Identity() + 2 * strain;
  return Eigen::LLT<Matrix2d>(c).matrixU();
}

Matrix2d pulled_back(const Matrix2d& f, const Matrix2d& cauchy) {
  const Matrix2d inverse = f.inverse();
  return f.determinant() * inverse * cauchy * inverse.transpose();
}

}  // namespace atomistic
