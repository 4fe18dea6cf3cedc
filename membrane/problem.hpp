// What a membrane run is asked for and what it hands back: plain data, Å and eV throughout.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "membrane/bending/moduli.hpp"
#include "membrane/laws/list.hpp"
#include "membrane/sheets/sheet.hpp"

namespace membrane {

/// Dead transverse force on the node at the centre (one node: the depth depends on the mesh there).
struct PointLoad {};

/// Dead transverse force, uniform per reference area over r <= radius_A.
struct DiscLoad {
  double radius_A = 0;
};

/// Dead transverse force of any round distribution: relative density over the radius, linear between the given pairs,
/// zero outside the last. Only ratios count.
struct RadialLoad {
  std::vector<double> radius_A, density;
};

/// Rigid frictionless sphere from above; its depth is 0 where it touches the flat sheet.
struct SphereLoad {
  double radius_A = 0;
};

/// Follower pressure towards −z: levels are pressures, eV/Å³, or mean depths (volume under the sheet over its
/// area, Å). Edges must stay in the plane z = 0.
struct PressureLoad {};

/// A clamped edge moves as a rigid body: levels are multiples of this motion.
struct EdgeMotion {
  Edge edge = Edge::hub;
  Eigen::Vector3d translation_A = Eigen::Vector3d::Zero();
  Eigen::Vector2d pivot_A = Eigen::Vector2d::Zero();  ///< of the rotation about the z axis
  double rotation_rad = 0;
};

using Load = std::variant<PointLoad, DiscLoad, RadialLoad, SphereLoad, PressureLoad, EdgeMotion>;

/// What the levels prescribe: the load's displacement (depth, mean depth, motion) or its force (force,
/// pressure). A motion is always a displacement.
enum class Control { conjugate_depth, force };

struct SolverOptions {
  double relative_residual = 1e-8;  ///< |free residual| / |applied load|; supports and load differ by no more
  int most_iterations = 400;        ///< Newton steps of one search for an equilibrium
  bool keep_factor = true;          ///< go on with an old factor while it serves; false: a new one each step
};

struct Problem {
  Sheet sheet;
  Law law;  ///< acts in membrane forces (eV/Å²): its modulus is E·h
  /// Second Piola–Kirchhoff prestress times thickness, eV/Å².
  Eigen::Matrix2d prestress_eV_per_A2 = Eigen::Matrix2d::Zero();
  bool relaxed = true;  ///< tension-field energy; false: the law as it stands, compression included
  /// Resistance to bending, with clamped edges held in slope, too. Needs relaxed = false: bending is what limits
  /// compression, and relaxing would count its relief twice. Rings are then narrow at the rim and at the load's edge.
  std::optional<BendingModuli> bending;
  double pressure_eV_per_A3 = 0;  ///< towards −z, applied before the load and kept under it
  Load load;
  Control control = Control::conjugate_depth;
  std::vector<double>
      levels;  ///< depths (Å), forces (eV/Å), pressures (eV/Å³) or multiples of a motion, along the path
  double record_radius_A = 0;  ///< the depth of record is taken at this radius; 0: the centre
  SolverOptions solver;
};

/// One equilibrium on the path. Forces and energies are those of the full sheet, never of the quarter.
struct Step {
  int level = 0;  ///< index into Problem::levels
  bool converged = false;
  double depth_A = 0;            ///< −z at record_radius_A
  double conjugate_depth_A = 0;  ///< Σ p_i (−z_i) of the load pattern; of a sphere its own, of a pressure volume / area
  double force_eV_per_A = 0;     ///< of a pattern or a sphere; else 0
  double pressure_eV_per_A3 = 0;
  double volume_A3 = 0;                  ///< between the sheet and its plane, positive on the side of −z
  double energy_eV = 0;                  ///< stretching and bending, relative to the flat, prestressed sheet
  double bending_energy_eV = 0;          ///< of which bending
  double relative_residual = 0;          ///< |free residual| / |applied load|: at most 1e-8, or rounding where the
                                         ///< depth is below some 1e-4 of the radius
  std::vector<double> residual_history;  ///< of the last search, one entry a Newton step
  int smallest_pivot_sign = 1;           ///< of the last tangent: −1 indefinite, 0 singular (slack), 1 positive
  double penetration_A = 0;              ///< deepest of a node into an obstacle
  /// Largest principal membrane force (second Piola–Kirchhoff) in the rim's triangles.
  double rim_membrane_force_eV_per_A2 = 0;
  /// Force of the supports on the sheet; z component only for a quarter (the others cancel in the full sheet).
  Eigen::Vector3d support_force_eV_per_A = Eigen::Vector3d::Zero();
  /// Of a moved edge: force on it and torque about its pivot's z axis (eV).
  Eigen::Vector3d edge_force_eV_per_A = Eigen::Vector3d::Zero();
  double edge_torque_eV = 0;
  int newton_iterations = 0;
  Eigen::VectorXd displacements;  ///< Å, three a node of make_mesh's mesh
  Eigen::VectorXd reactions;      ///< eV/Å on the meshed part, of the supports and symmetry planes on the nodes
};

struct Report {
  bool converged = false;         ///< every level reached
  std::string reason;             ///< why the path ended
  std::vector<std::string> cuts;  ///< why and where a level was not reached in one step
  int triangles = 0;              ///< of the mesh that was solved
  int factorisations = 0;
  int assemblies = 0;
};

/// Called after each level; returning false ends the path.
using OnStep = std::function<bool(const Step&)>;

/// Throws std::invalid_argument for a problem that makes no sense (named member, value, what is allowed).
void check(const Problem& problem);

/// The mesh that solve() uses.
Mesh mesh_of(const Problem& problem);

/// Follows the levels from the flat sheet. Throws as check() does; not converging is reported, not thrown.
Report solve(const Problem& problem, const OnStep& on_step);

}  // namespace membrane
