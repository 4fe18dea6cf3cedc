// The round sheet in one dimension: stretching by any law, bending, and the same loads as the triangles'
// sheet. The whole interface: plain data in, plain data out, Å and eV throughout.
#pragma once

#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "membrane/laws/list.hpp"

namespace membrane::axisymmetric {

/// Dead transverse force at the centre. Without bending the slope there is infinite, the depth finite.
struct PointLoad {};

/// Dead transverse force, uniform per reference area over r <= radius_A.
struct DiscLoad {
  double radius_A = 0;
};

/// Dead transverse force of any non-negative density per reference area, up to a factor, over r <= radius_A.
struct ProfileLoad {
  double radius_A = 0;
  std::function<double(double radius_A)> density;
};

/// Rigid frictionless sphere; its conjugate depth is that of its lowest point.
struct SphereLoad {
  double radius_A = 0;
};

/// The background pressure alone is the load: the levels are pressures, eV/Å³.
struct PressureLoad {};

using Load = std::variant<PointLoad, DiscLoad, ProfileLoad, SphereLoad, PressureLoad>;

/// clamped: no displacement, and no slope where the sheet resists bending. sliding: held in its plane, free
/// to move within it and to turn.
enum class Rim { clamped, sliding };

enum class Control { conjugate_depth, force };

/// A round sheet, its load and the levels to reach. Depths are positive the way the load pushes.
struct SheetProblem {
  double radius_A = 0;
  Law law;                          ///< acts in membrane forces (eV/Å²): its modulus is E·h
  bool relaxed = true;              ///< tension-field energy; a sheet that bends is not relaxed
  double bending_modulus_eV = 0;    ///< κ of ½ κ (κ1 + κ2)² per reference area; 0: membrane
  double pretension_eV_per_A2 = 0;  ///< isotropic second Piola–Kirchhoff prestress × thickness
  double pressure_eV_per_A3 = 0;    ///< follower pressure beside the load, the way of the depth where positive
  Rim rim = Rim::clamped;
  Load load;
  Control control = Control::conjugate_depth;
  std::vector<double> levels;  ///< conjugate depths (Å), forces (eV/Å) or pressures (eV/Å³), in order
  double record_radius_A = 0;  ///< the depth of record is taken at this reference radius
  double refinement = 1;       ///< elements are this much shorter than usual
};

/// The state on a circle.
struct SheetPoint {
  double radius_A = 0;        ///< in the reference
  double displacement_A = 0;  ///< outward
  double depth_A = 0;
  double radial_strain = 0;  ///< Green–Lagrange, without the prestress's offset
  double hoop_strain = 0;
  double radial_force_eV_per_A2 = 0;  ///< second Piola–Kirchhoff × thickness
  double hoop_force_eV_per_A2 = 0;
};

/// One equilibrium on the path.
struct SheetStep {
  int level = 0;  ///< index into SheetProblem::levels
  bool converged = false;
  double depth_A = 0;            ///< at record_radius_A
  double conjugate_depth_A = 0;  ///< mean over the load; the sphere's lowest point; 0 for pressure alone
  double force_eV_per_A = 0;     ///< of the load; its vertical resultant
  double pressure_eV_per_A3 = 0;
  double volume_A3 = 0;              ///< between the sheet and its plane
  double energy_eV = 0;              ///< stretching and bending, relative to the flat prestressed sheet
  double bending_energy_eV = 0;      ///< of which bending
  double rim_reaction_eV_per_A = 0;  ///< vertical force that the rim bears
  double relative_residual = 0;      ///< √(rᵀ K⁻¹ r / energy), at most 1e-9
  int iterations = 0;                ///< Newton's, cut-backs included
  std::vector<SheetPoint> points;    ///< from the centre to the rim
};

struct SheetReport {
  bool converged = false;  ///< every level reached
  std::string reason;      ///< why the path ended
  int elements = 0;
  int factorisations = 0;
};

/// Called after each level; returning false ends the path.
using OnSheetStep = std::function<bool(const SheetStep&)>;

/// Follows the levels from the flat sheet (with a background pressure: from the bulged one). Throws
/// std::invalid_argument for a problem that makes no sense; not converging is reported, not thrown.
SheetReport solve(const SheetProblem& problem, const OnSheetStep& on_step);

/// Throws std::invalid_argument naming the member, its value and what is allowed.
void check(const SheetProblem& problem);

}  // namespace membrane::axisymmetric
