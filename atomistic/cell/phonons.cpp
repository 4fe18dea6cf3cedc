#include "atomistic/cell/phonons.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "atomistic/cell/homogeneous_cell.hpp"
#include "atomistic/lammps/lammps.hpp"
#include "atomistic/vibration.hpp"

namespace atomistic {
namespace {

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::VectorXd;
using std::numbers::pi;

/// −∂(force on an atom)/∂(position of the one at the origin), `away` between their places in the unstrained sheet.
struct ForceConstant {
  Vector2d away;
  int sublattice;
  Matrix3d stiffness;
};
using AboutEach = std::array<std::vector<ForceConstant>, 2>;  // about an atom of each sublattice

/// Wide enough for every atom to feel one image of the displaced one, strained or not.
Supercell wide_cell(const Potential& potential, double a) {
  const double across = 2.3 * potential.interaction_range_A, row = a * std::numbers::sqrt3;
  return {static_cast<int>(std::ceil(across / a)) + 1, static_cast<int>(std::ceil(across / row)) + 1, a};
}

AboutEach about_each(const Potential& potential, const Supercell& cell, const Matrix2d& f, const Vector2d& shift,
                     const std::string& log_file) {
  constexpr double small = 1e-3;
  const Vector2d period(cell.along_x * cell.a, cell.along_y * cell.a * std::numbers::sqrt3);
  const VectorXd flat = cell.positions();
  VectorXd at_rest = flat;
  for (int i = 0; i < cell.atoms(); ++i)
    at_rest.segment<2>(3 * i) = f * flat.segment<2>(3 * i) + Supercell::sublattice(i) * shift;
  ForceField forces(potential, cell.box(f), at_rest, log_file);
  AboutEach found;
  for (const int atom : {0, 1}) {
    Eigen::MatrixXd columns(flat.size(), 3);
    for (const int axis : {0, 1, 2}) {
      VectorXd x = at_rest, ahead, behind;
      x[3 * atom + axis] += small;
      forces.evaluate(x, ahead, true);
      x[3 * atom + axis] -= 2 * small;
      forces.evaluate(x, behind, true);
      columns.col(axis) = (behind - ahead) / (2 * small);
    }
    Matrix3d sum = Matrix3d::Zero();
    auto& about = found[static_cast<std::size_t>(atom)];
    for (int i = 0; i < cell.atoms(); ++i) {
      Vector2d away = flat.segment<2>(3 * i) - flat.segment<2>(3 * atom);
      away -= (away.array() / period.array()).round().matrix().cwiseProduct(period);
      about.push_back({away, Supercell::sublattice(i), columns.middleRows<3>(3 * i)});
      sum += about.back().stiffness;
    }
    about[static_cast<std::size_t>(atom)].stiffness -= sum;  // what a translation would cost is rounding
  }
  return found;
}

Eigen::MatrixXcd dynamical(const AboutEach& constants, const Vector2d& q) {
  Eigen::MatrixXcd d = Eigen::MatrixXcd::Zero(6, 6);
  for (const int atom : {0, 1})
    for (const ForceConstant& c : constants[static_cast<std::size_t>(atom)])
      d.block<3, 3>(3 * c.sublattice, 3 * atom) += c.stiffness * std::polar(1.0, -q.dot(c.away));
  return (d + d.adjoint()) / 2;
}

/// z parts from the rest: the flat sheet is its own mirror image.
PhononSample sample_at(const AboutEach& constants, const Vector2d& q, double wave) {
  const Eigen::MatrixXcd d = dynamical(constants, q);
  constexpr std::array<int, 4> plane = {0, 1, 3, 4};
  constexpr std::array<int, 2> out = {2, 5};
  Eigen::Matrix4cd in_plane;
  Eigen::Matrix2cd out_of_plane;
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < 4; ++k)
      in_plane(i, k) = d(plane[static_cast<std::size_t>(i)], plane[static_cast<std::size_t>(k)]);
  for (int i = 0; i < 2; ++i)
    for (int k = 0; k < 2; ++k)
      out_of_plane(i, k) = d(out[static_cast<std::size_t>(i)], out[static_cast<std::size_t>(k)]);
  const Eigen::Vector4d four = Eigen::SelfAdjointEigenSolver<Eigen::Matrix4cd>(in_plane).eigenvalues();
  const Eigen::Vector2d two = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2cd>(out_of_plane).eigenvalues();
  return {wave, {four[0], four[1], four[2], four[3], two[1]}, two[0]};
}

/// The nearest of the equivalent wave vectors.
double shortest(const Vector2d& q, const Vector2d& b1, const Vector2d& b2) {
  double least = q.norm();
  for (const int i : {-1, 0, 1})
    for (const int k : {-1, 0, 1}) least = std::min(least, (q - i * b1 - k * b2).norm());
  return least;
}

}  // namespace

std::vector<PhononSample> phonons(const Potential& potential, const Card& card, const Matrix2d& strain, int mesh,
                                  const std::string& log_file) {
  const Matrix2d f = gradient_of_strain(strain);
  HomogeneousCell relaxed(potential, {6, 4, card.a0_A}, log_file);
  relaxed.relaxed(f);
  const AboutEach constants = about_each(potential, wide_cell(potential, card.a0_A), f, relaxed.shift(), log_file);
  const double k = 2 * pi / card.a0_A;
  const Vector2d b1(k, -k / std::numbers::sqrt3), b2(0, 2 * k / std::numbers::sqrt3);
  std::vector<PhononSample> samples;
  for (int i = 0; i < mesh / 2; ++i)  // the other half are the −q
    for (int j = 0; j < mesh; ++j) {
      const Vector2d q = (i + 0.5) / mesh * b1 + (j + 0.5) / mesh * b2;
      samples.push_back(sample_at(constants, q, shortest(q, b1, b2)));
    }
  return samples;
}

namespace {
constexpr double left_to_the_sheet = 1e-4;  // a weight that does not count
}

double phonon_free_energy(const std::vector<PhononSample>& samples, const Card& card, double mass_u, const Heat& heat,
                          double shortest_q_per_A) {
  double sum = 0;
  for (const PhononSample& s : samples) {
    for (const double value : s.others_eV_per_A2) sum += oscillator_free_energy_eV(value, mass_u, heat);
    const double weight = -std::expm1(-std::pow(s.wave_per_A / shortest_q_per_A, 8));
    if (weight > left_to_the_sheet) sum += weight * oscillator_free_energy_eV(s.flexural_eV_per_A2, mass_u, heat);
  }
  return sum / (static_cast<double>(samples.size()) * 2 * card.area_per_atom_A2());
}

}  // namespace atomistic
