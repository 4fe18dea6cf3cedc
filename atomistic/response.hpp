// How a flat sheet answers large homogeneous strain, as plain data: stress–strain curves, strength, and single states.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace atomistic {

/// A homogeneous in-plane strain: Green–Lagrange components in axes that are turned by orientation_deg from zigzag.
struct StrainState {
  double E11 = 0, E22 = 0, E12 = 0;
  double orientation_deg = 0;
};

/// The answer, in the same axes, the sublattices relaxed. Membrane forces in eV/Å².
struct HomogeneousState {
  StrainState strain;
  double S11_eV_per_A2 = 0, S22_eV_per_A2 = 0, S12_eV_per_A2 = 0;  ///< second Piola–Kirchhoff
  double energy_eV_per_A2 = 0;  ///< per reference area, relative to the unstrained sheet
  double longest_bond_A = 0;
  double shift_x_A = 0, shift_y_A = 0;  ///< inner displacement of one sublattice beyond the affine one, in the sheet's
                                        ///< axes (zigzag along x) after the deformation's upper-triangular gradient
  bool converged = false;               ///< the sublattices are in balance, and stable in it
};

/// A stress–strain curve. Nominal strain (stretch − 1) against nominal stress (first Piola–Kirchhoff membrane force);
/// uniaxial: the lateral stress vanishes. It ends where the stress has fallen below 95 % of its maximum, a bond has
/// broken or the relaxation fails.
struct StressCurve {
  std::string direction;  ///< zigzag, armchair (uniaxial stress), equibiaxial
  std::vector<double> strain, lateral_strain, stress_eV_per_A2, longest_bond_A;
  double secant_2_eV_per_A2 = 0, secant_5_eV_per_A2 = 0, secant_10_eV_per_A2 = 0;  ///< stress / strain at 2, 5, 10 %
  double strength_eV_per_A2 = 0;                                                   ///< largest stress
  double strain_at_strength = 0;          ///< the longest stable strain under held force
  std::optional<double> artefact_strain;  ///< where the longest bond reaches the potential's artefact length
};

/// What LAMMPS says of a set of atoms at given positions.
struct AtomForces {
  double energy_eV = 0;
  Eigen::VectorXd forces_eV_per_A;  ///< 3N, atom by atom
};

struct Response {
  std::vector<StressCurve> curves;
  std::vector<HomogeneousState> states;
};

}  // namespace atomistic
