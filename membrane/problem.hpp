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
#include "membrane/loads/list.hpp"
#include "membrane/sheets/edge_elasticity.hpp"
#include "membrane/sheets/sheet.hpp"

namespace membrane {

/// A mesh of triangles, as the sheet's own members say: any sheet, law and load.
struct Triangles {
  double relative_residual = 1e-8;  ///< |free residual| / |applied load|; supports and load differ by no more
  int most_iterations = 400;        ///< Newton steps of one search for an equilibrium
  bool keep_factor = true;          ///< go on with an old factor while it serves; false: a new one each step
};

/// The meridian of a disc in one dimension: fast and accurate. Laws without directions, even prestress, round loads at
/// positive levels; a pressure by its value only. What it cannot do check() names.
struct Meridian {
  double refinement = 1;  ///< elements are this much shorter than usual; a disc's rings and spacing are of triangles
};

using Discretisation = std::variant<Triangles, Meridian>;

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
  /// Dead force on a length of the edges that slide, outwards in the plane; applied before the load and kept under it.
  double edge_tension_eV_per_A2 = 0;
  EdgeElasticity edge;  ///< of its own, of the edges that slide; needs a tension beside it
  Load load;
  Control control = Control::conjugate_depth;
  std::vector<double>
      levels;  ///< depths (Å), forces (eV/Å), pressures (eV/Å³) or multiples of a motion, along the path
  double record_radius_A = 0;  ///< the depth of record is taken at this radius; 0: the centre
  Discretisation discretisation = Triangles{};
};

/// Where a sheet has given compression up, or bears it; areas of the flat sheet.
struct Tautness {
  double wrinkled_area_fraction = 0, slack_area_fraction = 0;  ///< of a relaxed sheet
  double compressed_area_fraction = 0;                         ///< of any other: the smaller membrane force is negative
  double least_force_eV_per_A2 = 0;  ///< the smallest principal membrane force (second Piola–Kirchhoff) anywhere
};

/// What is known on a mesh of triangles, make_mesh's.
struct TriangleShape {
  Eigen::VectorXd displacements;         ///< Å, three a node
  Eigen::VectorXd reactions;             ///< eV/Å on the meshed part, of the supports and symmetry planes on the nodes
  std::vector<double> residual_history;  ///< of the last search, one entry a Newton step
  int smallest_pivot_sign = 1;           ///< of the last tangent: −1 indefinite, 0 singular (slack), 1 positive
  /// Of a sheet that bends: the second derivative of the energy along the softest direction (eV/Å²), at the equilibrium
  /// that is handed out and at the first one that was found at this level: where that was negative it was a saddle and
  /// left for a lower state.
  std::optional<double> softest_eV_per_A2, first_softest_eV_per_A2;
  int saddles_left = 0;
};

/// The state on a circle.
struct MeridianPoint {
  double radius_A = 0;        ///< in the reference
  double displacement_A = 0;  ///< outward
  double depth_A = 0;
  double radial_strain = 0;  ///< Green–Lagrange, without the prestress's offset
  double hoop_strain = 0;
  double radial_force_eV_per_A2 = 0;  ///< second Piola–Kirchhoff × thickness
  double hoop_force_eV_per_A2 = 0;
};

/// What is known along a meridian.
struct MeridianShape {
  std::vector<MeridianPoint> points;  ///< from the centre to the rim
};

/// One equilibrium on the path. Forces and energies are those of the full sheet, never of the quarter.
struct Step {
  int level = 0;  ///< index into Problem::levels
  bool converged = false;
  double depth_A = 0;            ///< −z at record_radius_A
  double conjugate_depth_A = 0;  ///< Σ p_i (−z_i) of the load pattern; of a sphere its own, of a pressure volume / area
  double force_eV_per_A = 0;     ///< of a pattern or a sphere; of a pressure by its volume p A; else 0
  double pressure_eV_per_A3 = 0;
  double volume_A3 = 0;  ///< between the sheet and its plane, positive on the side of −z
  /// Stretching, bending and the potential of an edge's dead tension, relative to the flat sheet that is under its
  /// prestress or that tension.
  double energy_eV = 0;
  double bending_energy_eV = 0;  ///< of which bending
  /// Triangles: |free residual| / |applied load|, at most 1e-8, or rounding where the depth is below some 1e-4 of the
  /// radius. Meridian: √(rᵀ K⁻¹ r / energy), at most 1e-9.
  double relative_residual = 0;
  double penetration_A = 0;  ///< deepest of a node into an obstacle; a meridian stays outside
  /// Largest principal membrane force (second Piola–Kirchhoff) at the rim: of its triangles, or on its circle.
  double rim_membrane_force_eV_per_A2 = 0;
  Tautness tautness;
  double rim_displacement_A = 0;  ///< of a round sheet's rim, outwards, mean
  /// Force of the supports on the sheet; z component only where no more than a quarter is solved (the others cancel in
  /// the full sheet).
  Eigen::Vector3d support_force_eV_per_A = Eigen::Vector3d::Zero();
  /// Of a moved edge: force on it and torque about its pivot's z axis (eV).
  Eigen::Vector3d edge_force_eV_per_A = Eigen::Vector3d::Zero();
  double edge_torque_eV = 0;
  int newton_iterations = 0;  ///< cut-backs included
  std::variant<TriangleShape, MeridianShape> shape;

  /// Of a problem on triangles; throws std::bad_variant_access for another.
  const TriangleShape& on_triangles() const { return std::get<TriangleShape>(shape); }
  /// Of a problem on a meridian; throws std::bad_variant_access for another.
  const std::vector<MeridianPoint>& on_meridian() const { return std::get<MeridianShape>(shape).points; }
};

struct Report {
  bool converged = false;         ///< every level reached
  std::string reason;             ///< why the path ended
  std::vector<std::string> cuts;  ///< why and where a level was not reached in one step
  int elements = 0;               ///< that were solved: triangles, or those of the meridian
  int factorisations = 0;
  int assemblies = 0;  ///< of the energy and its gradient or Hessian
};

/// Called after each level; returning false ends the path.
using OnStep = std::function<bool(const Step&)>;

/// Throws std::invalid_argument for a problem that makes no sense, or that its discretisation cannot solve (named
/// member, value, what is allowed).
void check(const Problem& problem);

/// The mesh that solve() uses on triangles.
Mesh mesh_of(const Problem& problem);

/// Follows the levels from the flat sheet (beside a pressure: from the bulged one). Throws as check() does; not
/// converging is reported, not thrown.
Report solve(const Problem& problem, const OnStep& on_step);

}  // namespace membrane
