// Extended XYZ of one sheet of atoms, for OVITO and ASE.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace validate {

/// One equilibrium of the sheet. The arrays hold one entry per atom, in the same order.
struct Snapshot {
  std::string potential, load;
  double depth_A = 0;         ///< depth of record
  double force_eV_per_A = 0;  ///< total on the sheet
  std::span<const Eigen::Vector3d> positions_A;
  std::span<const Eigen::Vector3d> forces_eV_per_A;  ///< of the potential, without the load
  std::span<const double> longest_bond_A;            ///< longest bond of each atom
  std::span<const int> clamped;                      ///< 1 where the atom is held
};

/// All atoms are carbon; the cell is a box around them, with no periodic direction. Throws
/// std::invalid_argument for arrays of different length.
std::string extxyz(const Snapshot& sheet);

/// Writes `extxyz` atomically; throws Error (file failed).
void write_extxyz(const Snapshot& sheet, const std::filesystem::path& file);

/// An atom as a picture from above needs it.
struct AtomFromAbove {
  double x_A = 0, y_A = 0, longest_bond_A = 0;
};

/// The free atoms of such a file; none where there is no file. Lines that are no atom's are passed over.
std::vector<AtomFromAbove> read_free_atoms(const std::filesystem::path& file);

}  // namespace validate
