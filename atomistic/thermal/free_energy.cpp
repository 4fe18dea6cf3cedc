#include "atomistic/thermal/free_energy.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace atomistic {

using Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;
using std::numbers::pi;

namespace {

/// Beyond the frequency whose s_n is this many largest eigenvalues the product goes on by traces: what they leave out
/// is a third of the cube of its inverse for the stiffest mode.
constexpr double eigenvalues_before_traces = 10;

struct Sum {
  double squares = 0, fourth_powers = 0;  ///< Σ n⁻², Σ n⁻⁴ beyond the last that was written out
};

Sum tail_beyond(int last) {
  Sum tail{pi * pi / 6, std::pow(pi, 4) / 90};
  for (int n = 1; n <= last; ++n) {
    tail.squares -= std::pow(n, -2.0);
    tail.fourth_powers -= std::pow(n, -4.0);
  }
  return tail;
}

Matrix shifted(const Matrix& matrix, double shift) {
  Matrix sum = matrix;
  sum.diagonal().array() += shift;
  return sum;
}

}  // namespace

VibrationalFreeEnergy::VibrationalFreeEnergy(const Heat& heat, double mass_u)
    : kT_eV_(constants::boltzmann_eV_per_K * heat.temperature_K), statistics_(heat.statistics) {
  const double first_frequency = 2 * pi * kT_eV_ / constants::hbar_eV_s;
  first_shift_eV_per_A2_ = mass_u * constants::atomic_mass_eV_s2_per_A2 * first_frequency * first_frequency;
}

std::optional<VibrationEnergy> VibrationalFreeEnergy::operator()(const Matrix& hessian, const VectorXd& c,
                                                                 DefiniteFactor& factor) const {
  if (!factor.factorise(hessian)) return std::nullopt;
  const double all = factor.log_determinant();
  const double held = c.size() ? std::log(c.dot(factor.solve(c)) / c.squaredNorm()) : 0.0;
  VibrationEnergy energy{kT_eV_ * all / 2, kT_eV_ * (all + held) / 2};
  if (statistics_ == Statistics::quantum) {
    const VibrationEnergy more = quantum_part(hessian, c);
    energy.free_eV += more.free_eV;
    energy.held_eV += more.held_eV;
  }
  return energy;
}

VibrationEnergy VibrationalFreeEnergy::quantum_part(const Matrix& hessian, const VectorXd& c) const {
  const double s1 = first_shift_eV_per_A2_, size = static_cast<double>(hessian.rows());
  const int written_out = static_cast<int>(std::sqrt(eigenvalues_before_traces * largest_eigenvalue(hessian) / s1));
  DefiniteFactor factor;
  double all = 0, held = 0;
  for (int n = 1; n <= written_out; ++n) {
    const double shift = s1 * n * n;
    factor.factorise(shifted(hessian, shift));
    all += factor.log_determinant() - size * std::log(shift);
    if (c.size()) held += std::log(shift * c.dot(factor.solve(c)) / c.squaredNorm());
  }
  const Sum tail = tail_beyond(written_out);
  all += tail.squares * hessian.diagonal().sum() / s1 - tail.fourth_powers * hessian.squaredNorm() / (2 * s1 * s1);
  if (c.size()) held -= tail.squares * c.dot(hessian * c) / c.squaredNorm() / s1;
  return {kT_eV_ * all, kT_eV_ * (all + held)};
}

double largest_eigenvalue(const Matrix& matrix) {
  constexpr int iterations = 20;
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  VectorXd v(matrix.rows());
  for (double& component : v) component = normal(random);
  double found = 0;
  for (int i = 0; i < iterations; ++i) {
    v.normalize();
    const VectorXd next = matrix * v;
    found = std::max(found, v.dot(next));
    v = next;
  }
  return found;
}

}  // namespace atomistic
