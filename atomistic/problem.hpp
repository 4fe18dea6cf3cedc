// What an atomistic run is asked for and what it hands back: plain data, Å and eV throughout.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace atomistic {

/// How LAMMPS is told about a carbon potential. `{file}` in a pair_coeff line stands for the absolute path.
struct Potential {
  std::string name, pair_style;
  std::vector<std::string> pair_coeff;
  std::string file;       ///< absolute path; empty: none
  std::string kim_model;  ///< an OpenKIM simulator model that sets style and coefficients itself; empty: none
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
  double sublattice_stiffness_eV_per_A2 = 0;  ///< out of plane, per atom, one sublattice moved against the other
  double bond_softening = 0;                  ///< s in the bond stiffness k (1 − s ε) under equibiaxial strain ε
  double clamp_margin_bonds = 0;  ///< displacements end this far beyond the free atoms' area (cell/clamp_margins.hpp)
  double slope_margin_bonds = 0;  ///< where they do the slope is this length times the curvature

  double bond_A() const { return a0_A / 1.7320508075688772; }
  double area_per_atom_A2() const { return 0.4330127018922193 * a0_A * a0_A; }
  double nu() const { return C12_eV_per_A2 / C11_eV_per_A2; }
  double sheet_modulus_eV_per_A2() const { return C11_eV_per_A2 * (1 - nu() * nu()); }
  double bending_modulus_eV() const { return (bending_modulus_zigzag_eV + bending_modulus_armchair_eV) / 2; }
};

/// The atoms nearest to the axis share the force: the central hexagon's six, or the central atom.
struct PointLoad {};

/// The atoms with r <= radius_A share the force equally.
struct DiscLoad {
  double radius_A = 0;
};

/// Rigid frictionless sphere, pressed down along the axis. Atoms (as points) inside it are pushed out along its radius
/// r with the force K (radius − r)², LAMMPS's `fix indent`. The conjugate depth is that of its lowest point.
struct SphereLoad {
  double radius_A = 0;
  double stiffness_eV_per_A3 = 100;  ///< K; an atom that carries 0.2 eV/Å is 0.045 Å inside
};

/// Pressure from above on the free sheet; levels are pressures (eV/Å³). Following: normal to the deformed surface, from
/// the energy −p V with V the volume swept. Dead: along −z, with each atom's share of the flat area.
struct PressureLoad {
  bool following = true;
};

using Load = std::variant<PointLoad, DiscLoad, SphereLoad, PressureLoad>;

enum class Control { conjugate_depth, force };

enum class Shape { disc, square };
enum class Centre { hexagon, atom };
enum class Edge {
  clamped,  ///< atoms beyond the free sheet are held
  sliding   ///< the sheet ends; its outermost atoms keep z = 0 and slide in the plane
};

/// What the sheet is beside its size: by default a clamped, hexagon-centred, perfect disc with zigzag along x.
struct SheetForm {
  Shape shape = Shape::disc;
  Edge edge = Edge::clamped;
  Centre centre = Centre::hexagon;
  double rotation_deg = 0;                   ///< of the lattice about the axis, counter-clockwise
  std::vector<Eigen::Vector2d> vacancies;    ///< the atom nearest to each place is missing, Å
  std::vector<Eigen::Vector2d> stone_wales;  ///< the bond nearest to each place is turned by 90°, Å
};

/// What a continuum expects at a level, on the radii 0, spacing, 2 spacing, … up to its rim: displacements outward and
/// along the load.
struct Guide {
  double level = 0;
  double spacing_A = 0;
  std::vector<double> outward_A, depth_A;
};

/// How the metric of the minimisation is inverted. Automatic: by the number of free atoms.
enum class Preconditioning { automatic, factor, multigrid };

struct Problem {
  Potential potential;
  Card card;
  double radius_A = 0;  ///< of the free disc, or half the side of the square; atoms beyond are clamped
  SheetForm form;
  double biaxial_strain = 0;         ///< imposed on the whole flat sheet before the load: the pretension
  double rim_tension_eV_per_A2 = 0;  ///< dead force on a length of a sliding disc's rim, outwards, before the load
  Load load;
  Control control = Control::conjugate_depth;
  std::vector<double>
      levels;  ///< conjugate depths (Å), total forces (eV/Å) or pressures (eV/Å³), in the order of the path
  std::vector<Guide> guides;  ///< where levels start from, for those that have one; the result does not depend on them
  bool unload = false;        ///< then back through the levels that were reached, down to the first
  double force_tolerance_eV_per_A = 1e-5;
  int max_evaluations = 600;   ///< per level; then the path ends as not converged
  bool past_artefact = false;  ///< do not end the path at the artefact bond length
  double ripple_A = 0;         ///< root mean square of the ripple that every level starts from, beside its prediction
  unsigned ripple_seed = 0;    ///< of the first level; the next ones count on
  int ripple_waves = 0;        ///< the ripple has this many waves around the axis; 0: waves of any direction
  bool virials = false;        ///< hand out each step's virials
  Preconditioning preconditioning = Preconditioning::automatic;
};

/// Positions and forces are 3N vectors, atom by atom; free atoms first (see Sheet).
struct Step {
  int level = 0;  ///< counts the steps of the path; index into Problem::levels while loading, up to a search
  bool unloading = false;
  bool search = false;  ///< no level: a try between the last that was borne and the first that broke
  bool broken = false;  ///< the sheet has come apart
  double target = 0;    ///< the level asked for: Å, eV/Å or eV/Å³
  bool converged = false;
  double depth_A = 0;             ///< mean −z of the atoms at one bond from the axis (the central hexagon)
  double conjugate_depth_A = 0;   ///< of the load: mean −z of the loaded atoms, the sphere's travel, volume over area
  double force_eV_per_A = 0;      ///< work-conjugate to it
  double energy_eV = 0;           ///< work put in: relative to the flat sheet, contact included, dead loads not
  double max_force_eV_per_A = 0;  ///< largest norm left on a free atom, load removed
  double balance_relative = 0;    ///< |tip force + rim reaction| / tip force
  double force_error_relative = 0;  ///< gᵀP⁻¹g / (F d): estimated error of the tip force
  double longest_bond_A = 0;
  int evaluations = 0;     ///< force computations since this level was asked for
  int factorisations = 0;  ///< of the preconditioner, or set-ups of its multigrid, for this level
  int solves = 0;          ///< with the preconditioner: with its factor, or multigrid cycles
  Eigen::VectorXd positions, forces;
  Eigen::VectorXd factorised_at;  ///< positions of the factor in use when the level was finished
  Eigen::VectorXd virials;        ///< 6N where asked for, else empty: xx, yy, zz, xy, xz, yz of each atom's, eV
};

enum class Ended { depth_max, artefact, rupture, not_converged };

/// What a four times stiffer contact changes at the last depth of a sphere.
struct ContactCheck {
  double force_change_relative = 0;                 ///< at equal travel of the sphere
  double depth_change_A = 0;                        ///< of the depth of record, at equal travel
  double force_change_at_equal_depth_relative = 0;  ///< at equal depth of record: what a comparison of curves sees
  double deepest_penetration_A = 0;                 ///< at the stiffness of the run
};

struct Report {
  Ended ended = Ended::depth_max;
  std::string reason;
  std::optional<ContactCheck> contact;  ///< for a sphere
  int relaxation_evaluations = 0;       ///< of the flat sheet, where it is not built in equilibrium
  long force_calls = 0;
  double force_s = 0;                                         ///< pair, neighbour and communication time inside LAMMPS
  Preconditioning preconditioning = Preconditioning::factor;  ///< that was used
  double factor_s = 0, solve_s = 0, setup_s = 0;
};

}  // namespace atomistic
