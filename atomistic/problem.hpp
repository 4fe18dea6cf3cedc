// What an atomistic run is asked for and what it hands back: plain data, Å and eV throughout.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace atomistic {

/// How LAMMPS is told about a carbon potential. `{file}` in a pair_coeff line stands for the absolute path.
struct Potential {
  std::string name, pair_style;
  std::vector<std::string> pair_coeff;
  std::string file;  ///< absolute path
  double mass = 12.011;
  double interaction_range_A = 0;  ///< an atom farther away than this does not change the force on another
  double artefact_bond_A = 1.70;   ///< from this bond length on, forces are an artefact of the cut-off
  std::string description, citation;
};

/// Linear response of the flat sheet at T = 0, relaxed inside the cell. Moduli are membrane forces, eV/Å².
struct Card {
  double a0_A = 0;
  double energy_per_atom_eV = 0;
  double C11_eV_per_A2 = 0, C12_eV_per_A2 = 0, C66_eV_per_A2 = 0;
  double bending_modulus_zigzag_eV = 0, bending_modulus_armchair_eV = 0;
  double sublattice_stiffness_eV_per_A2 =
      0;                      ///< out of plane, per atom, one sublattice moved against the other
  double bond_softening = 0;  ///< s in the bond stiffness k (1 − s ε) under equibiaxial strain ε

  double bond_A() const { return a0_A / 1.7320508075688772; }
  double area_per_atom_A2() const { return 0.4330127018922193 * a0_A * a0_A; }
  double nu() const { return C12_eV_per_A2 / C11_eV_per_A2; }
  double sheet_modulus_eV_per_A2() const { return C11_eV_per_A2 * (1 - nu() * nu()); }
  double bending_modulus_eV() const { return (bending_modulus_zigzag_eV + bending_modulus_armchair_eV) / 2; }
};

/// The six atoms of the central hexagon share the force.
struct PointLoad {};

/// The atoms with r <= radius_A share the force equally.
struct DiscLoad {
  double radius_A = 0;
};

using Load = std::variant<PointLoad, DiscLoad>;

enum class Control { conjugate_depth, force };

struct Problem {
  Potential potential;
  Card card;
  double radius_A = 0;        ///< atoms beyond are clamped
  double biaxial_strain = 0;  ///< imposed on the whole flat sheet before the load: the pretension
  Load load;
  Control control = Control::conjugate_depth;
  std::vector<double> levels;  ///< conjugate depths (Å) or total forces (eV/Å), in the order of the path
  double force_tolerance_eV_per_A = 1e-5;
  int max_evaluations = 600;   ///< per level; then the path ends as not converged
  bool past_artefact = false;  ///< do not end the path at the artefact bond length
};

/// Positions and forces are 3N vectors, atom by atom; free atoms first (see Sheet).
struct Step {
  int level = 0;  ///< index into Problem::levels
  bool converged = false;
  double depth_A = 0;            ///< mean −z of the central hexagon
  double conjugate_depth_A = 0;  ///< mean −z of the loaded atoms
  double force_eV_per_A = 0;
  double energy_eV = 0;             ///< relative to the flat sheet (dead-load work not included)
  double max_force_eV_per_A = 0;    ///< largest norm left on a free atom, load removed
  double balance_relative = 0;      ///< |tip force + rim reaction| / tip force
  double force_error_relative = 0;  ///< gᵀP⁻¹g / (F d): estimated error of the tip force
  double longest_bond_A = 0;
  int evaluations = 0;     ///< force computations since this level was asked for
  int factorisations = 0;  ///< of the preconditioner, for this level
  Eigen::VectorXd positions, forces;
  Eigen::VectorXd factorised_at;  ///< positions of the factor in use when the level was finished
};

enum class Ended { depth_max, artefact, rupture, not_converged };

struct Report {
  Ended ended = Ended::depth_max;
  std::string reason;
  long force_calls = 0;
  double force_s = 0;  ///< pair, neighbour and communication time inside LAMMPS
  double factor_s = 0, solve_s = 0, setup_s = 0;
};

}  // namespace atomistic
