#include "atomistic/equilibrium/spring_network.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace atomistic {

using Eigen::Matrix3d;
using Eigen::Vector3d;

SpringConstants spring_constants(const Card& card) {
  const double l = card.bond_A(), atom_area = card.area_per_atom_A2();
  const double stretch = std::numbers::sqrt3 * (card.C11_eV_per_A2 + card.C12_eV_per_A2);
  // In shear the bonds (3/2 k_r l²) and the angles (9 k_θ) act in series through the inner displacement.
  const double shear = (card.C11_eV_per_A2 - card.C12_eV_per_A2) * atom_area;
  const double bonds = 1.5 * stretch * l * l;
  if (!(shear > 0 && shear < bonds && card.bending_modulus_eV() > 0 && card.sublattice_stiffness_eV_per_A2 > 0))
    throw std::invalid_argument("spring network: the card's moduli do not describe a stable sheet");
  const double long_waves = 16 * card.bending_modulus_eV() * atom_area / std::pow(l, 4);
  const double sublattices = card.sublattice_stiffness_eV_per_A2 / 4;
  return {.rest_length_A = l,
          .stretch_eV_per_A2 = stretch,
          .softening = card.bond_softening,
          .angle_eV = shear * bonds / (bonds - shear) / 9,
          .out_of_plane_eV_per_A2 = std::sqrt(long_waves * sublattices)};
}

struct SpringNetwork::Element {
  std::array<int, 4> atoms;
  std::array<Vector3d, 4> gradient;
  int size;
};

SpringNetwork::SpringNetwork(const Sheet& sheet, const SpringConstants& constants, Blocks blocks, int ghosts)
    : sheet_(sheet), constants_(constants), blocks_(blocks), rows_end_(sheet.free_atoms + ghosts) {
  build_pattern();
}

/// First and second neighbours are coupled: two atoms that share a bond, an angle or a common neighbour.
void SpringNetwork::build_pattern() {
  const int free = sheet_.free_atoms;
  start_.assign(1, 0);
  std::vector<int> coupled;
  for (int j = 0; j < free; ++j) {
    coupled.assign(1, j);
    for (int n : sheet_.neighbours[j]) {
      if (n < 0) continue;
      coupled.push_back(n);
      for (int second : sheet_.neighbours[n]) coupled.push_back(second);
    }
    std::sort(coupled.begin(), coupled.end());
    coupled.erase(std::unique(coupled.begin(), coupled.end()), coupled.end());
    for (int i : coupled)
      if (i >= (blocks_ == Blocks::lower ? j : 0) && i < rows_end_) rows_.push_back(i);
    start_.push_back(static_cast<long>(rows_.size()));
  }
}

void SpringNetwork::assemble(const Eigen::VectorXd& positions, const std::vector<AtomStiffness>& load,
                             double* values) const {
  std::fill_n(values, numbers(), 0.0);
  add_identity(values);
  add_bonds(positions, values);
  add_angles(positions, values);
  add_out_of_plane(positions, values);
  for (const auto& [atom, stiffness] : load) add_block(atom, atom, stiffness, values);
}

/// An atom that slides keeps its z: the one number that its row and column have there.
void SpringNetwork::add_identity(double* values) const {
  for (int i = 0; i < sheet_.free_atoms; ++i) {
    Matrix3d block = constants_.identity_eV_per_A2 * Matrix3d::Identity();
    add_block(i, i, block, values);
    if (!slides(i)) continue;
    const auto begin = rows_.begin() + start_[i], end = rows_.begin() + start_[i + 1];
    const auto at = std::lower_bound(begin, end, i) - begin, blocks = end - begin;
    values[9 * start_[i] + 3 * blocks * 2 + 3 * at + 2] = 1;
  }
}

void SpringNetwork::add_block(int i, int j, Matrix3d block, double* values) const {
  if (j >= sheet_.free_atoms || i >= rows_end_ || (blocks_ == Blocks::lower && i < j)) return;
  if (slides(i)) block.row(2).setZero();
  if (slides(j)) block.col(2).setZero();
  const auto begin = rows_.begin() + start_[j], end = rows_.begin() + start_[j + 1];
  const auto at = std::lower_bound(begin, end, i) - begin;
  const auto blocks = end - begin;
  double* value = values + 9 * start_[j] + 3 * at;
  for (int c = 0; c < 3; ++c, value += 3 * blocks) Eigen::Map<Vector3d>{value} += block.col(c);
}

void SpringNetwork::add_rank_one(double stiffness, const Element& element, double* values) const {
  for (int a = 0; a < element.size; ++a)
    for (int b = 0; b < element.size; ++b)
      add_block(element.atoms[a], element.atoms[b], stiffness * element.gradient[a] * element.gradient[b].transpose(),
                values);
}

void SpringNetwork::add_bonds(const Eigen::VectorXd& positions, double* values) const {
  for (const auto& [i, j] : sheet_.bonds) {
    const Vector3d d = positions.segment<3>(3 * i) - positions.segment<3>(3 * j);
    const double l = d.norm(), strain = l / constants_.rest_length_A - 1, s = constants_.softening;
    const double stiffness = constants_.stretch_eV_per_A2 * std::max(1 - s * strain, 0.2);  // stays definite
    const double tension = constants_.stretch_eV_per_A2 * constants_.rest_length_A * strain * (1 - s * strain / 2);
    const Matrix3d along = d * d.transpose() / (l * l);
    const Matrix3d block = stiffness * along + std::max(tension, 0.0) / l * (Matrix3d::Identity() - along);
    add_block(i, i, block, values);
    add_block(j, j, block, values);
    add_block(i, j, -block, values);
    add_block(j, i, -block, values);
  }
}

/// θ at atom i between its neighbours j and k: ∂θ/∂x_j = −t_j / l_j, t_j the unit vector ⟂ (x_j − x_i)
/// towards k.
void SpringNetwork::add_angles(const Eigen::VectorXd& positions, double* values) const {
  for (int i = 0; i < sheet_.atoms(); ++i) {
    for (int p = 0; p < 3; ++p) {
      const int j = sheet_.neighbours[i][p], k = sheet_.neighbours[i][(p + 1) % 3];
      if (j < 0 || k < 0) continue;
      if (std::min({i, j, k}) >= rows_end_) continue;
      const Vector3d a = positions.segment<3>(3 * j) - positions.segment<3>(3 * i);
      const Vector3d b = positions.segment<3>(3 * k) - positions.segment<3>(3 * i);
      const Vector3d at_j = -(b - a * (a.dot(b) / a.squaredNorm())).normalized() / a.norm();
      const Vector3d at_k = -(a - b * (a.dot(b) / b.squaredNorm())).normalized() / b.norm();
      add_rank_one(constants_.angle_eV, {{i, j, k, -1}, {-at_j - at_k, at_j, at_k, Vector3d::Zero()}, 3}, values);
    }
  }
}

void SpringNetwork::add_out_of_plane(const Eigen::VectorXd& positions, double* values) const {
  for (int i = 0; i < sheet_.atoms(); ++i) {
    const auto [a, b, c] = sheet_.neighbours[i];
    if (a < 0 || b < 0 || c < 0) continue;
    const auto x = [&](int atom) { return positions.segment<3>(3 * atom); };
    const Vector3d normal = (x(b) - x(a)).cross(x(c) - x(a)).normalized();
    add_rank_one(constants_.out_of_plane_eV_per_A2, {{i, a, b, c}, {normal, -normal / 3, -normal / 3, -normal / 3}, 4},
                 values);
  }
}

}  // namespace atomistic
