// The graphene sheet: a piece of honeycomb, what of it is held, and its bonds.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "atomistic/problem.hpp"

namespace atomistic {

struct Sheet {
  double bond_A = 0;    ///< bond length of the perfect flat sheet as built (strain included)
  double radius_A = 0;  ///< half the side of a square
  SheetForm form;
  int free_atoms = 0;         ///< atoms 0 … free_atoms−1 move; the rest are clamped
  Eigen::VectorXd positions;  ///< 3N, flat in z = 0; around defects and sliding edges not yet in equilibrium
  std::vector<std::array<int, 3>> neighbours;  ///< bonded atoms, −1 where the sheet ends
  std::vector<std::array<int, 2>> bonds;       ///< each once, at least one end free
  std::vector<int> innermost;                  ///< carry a point load: the hexagon's six, or the one atom on the axis
  std::vector<int> record;                     ///< give the depth of record: at one bond from the axis
  std::vector<bool> slides;                    ///< of the free atoms: keeps z = 0 (sliding edge)

  int atoms() const { return static_cast<int>(positions.size()) / 3; }
  auto position(int atom) const { return positions.segment<3>(3 * atom); }

  /// The perfect clamped lattice is in equilibrium as built; a sheet with defects or a sliding edge is not.
  bool built_in_equilibrium() const {
    return form.vacancies.empty() && form.stone_wales.empty() && form.edge == Edge::clamped;
  }
};

/// Lattice constant a0_A stretched by 1 + biaxial_strain. Clamped: atoms beyond the disc of radius_A (or the
/// square of that half side) are held, on a ring of ring_width_A. Sliding: the sheet ends there, without
/// dangling atoms. Free atoms come first, each group sorted by lattice cell, so that the order depends on
/// nothing but the arguments. Throws std::invalid_argument for what cannot be built: too small, a defect
/// outside or on top of another, nothing left at the axis.
Sheet make_sheet(double radius_A, double a0_A, double biaxial_strain, double ring_width_A, const SheetForm& form = {});

/// Free and clamped atoms with r <= radius_A in the flat sheet.
std::vector<int> atoms_within(const Sheet& sheet, double radius_A);

/// Longest bond with a free end, Å.
double longest_bond(const Sheet& sheet, const Eigen::VectorXd& positions);

/// The rings of the sheet as loops of bonded atoms, counter-clockwise seen from above: hexagons, the
/// pentagons and heptagons of defects, the holes of vacancies. Only rings with a free atom; the outside is
/// none.
std::vector<std::vector<int>> rings(const Sheet& sheet);

}  // namespace atomistic
