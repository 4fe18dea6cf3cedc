// Membrane forces of a sheet of atoms, from its virials.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "atomistic/lattice/sheet.hpp"
#include "atomistic/problem.hpp"

namespace validate {

/// A coarse cell of the flat sheet and the membrane force that its atoms carry together.
struct VirialCell {
  std::array<Eigen::Vector2d, 4> corners_A;  ///< in the flat sheet, counter-clockwise
  Eigen::Vector2d middle_A = Eigen::Vector2d::Zero();
  double larger_eV_per_A2 = 0, smaller_eV_per_A2 = 0;  ///< principal, in the cell's mean plane, per current length
  int atoms = 0;
};

/// Half the normal vector of the triangle of an atom's three neighbours, upwards: in the flat sheet its length is the
/// area per atom, in a deformed one the area that the atom stands for. Zero where the atom lacks a neighbour.
Eigen::Vector3d area_of_atom(const atomistic::Sheet& sheet, const Eigen::VectorXd& positions, int atom);

/// The free sheet (a square) cut into cells × cells. In each: the sum of the virials over the area of the atoms' mean
/// plane, projected into that plane. Cells with fewer than `fewest` atoms are left out.
std::vector<VirialCell> virial_field(const atomistic::Sheet& sheet, const atomistic::Step& step, int cells,
                                     int fewest = 10);

}  // namespace validate
