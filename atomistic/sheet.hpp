// The graphene sheet: a hexagon-centred honeycomb disc with a clamped ring, and its bonds.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace atomistic {

struct Sheet {
  double bond_A = 0;  ///< bond length of the flat sheet as built (strain included)
  double radius_A = 0;
  int free_atoms = 0;         ///< atoms 0 … free_atoms−1 move; the rest (r > radius) are clamped
  Eigen::VectorXd positions;  ///< 3N, flat in z = 0, zigzag along x
  std::vector<std::array<int, 3>> neighbours;  ///< bonded atoms, −1 where the sheet ends
  std::vector<std::array<int, 2>> bonds;       ///< each once, at least one end free
  std::array<int, 6> hexagon{};                ///< the atoms nearest to the axis

  int atoms() const { return static_cast<int>(positions.size()) / 3; }
  auto position(int atom) const { return positions.segment<3>(3 * atom); }
};

/// Lattice constant a0_A stretched by 1 + biaxial_strain; atoms with r > radius_A are clamped, the ring is
/// ring_width_A wide. Free atoms come first, each group sorted by lattice cell, so that the order depends
/// on nothing but the arguments.
Sheet make_sheet(double radius_A, double a0_A, double biaxial_strain, double ring_width_A);

/// Atoms with r <= radius_A in the flat sheet.
std::vector<int> atoms_within(const Sheet& sheet, double radius_A);

/// Longest bond with a free end, Å.
double longest_bond(const Sheet& sheet, const Eigen::VectorXd& positions);

}  // namespace atomistic
