// What a membrane run is asked for and what it hands back: plain data, Å and eV throughout.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "membrane/laws/list.hpp"

namespace membrane {

/// Dead transverse force on the node at the centre (one node: the depth depends on the mesh there).
struct PointLoad {};

/// Dead transverse force, uniform per reference area over r <= radius_A.
struct DiscLoad {
  double radius_A = 0;
};

using Load = std::variant<PointLoad, DiscLoad>;

/// Flat disc, clamped at r = radius_A, meshed as one symmetric quarter.
struct DiscSheet {
  double radius_A = 0;
  int rings = 72;  ///< rings of triangles from the centre to the rim, ring i holds 2 i − 1
};

enum class Control { conjugate_depth, force };

struct Problem {
  DiscSheet sheet;
  Law law;  ///< acts in membrane forces (eV/Å²): its modulus is E·h
  /// Second Piola–Kirchhoff prestress times thickness, eV/Å².
  Eigen::Matrix2d prestress_eV_per_A2 = Eigen::Matrix2d::Zero();
  bool relaxed = true;  ///< tension-field energy; false: the law as it stands, compression included
  Load load;
  Control control = Control::conjugate_depth;
  std::vector<double> levels;  ///< conjugate depths (Å) or total forces (eV/Å), in the order of the path
  double record_radius_A = 0;  ///< the depth of record is taken at this radius; 0: the centre
};

/// One equilibrium on the path. Forces and energies are those of the full sheet, never of the quarter.
struct Step {
  int level = 0;  ///< index into Problem::levels
  bool converged = false;
  double depth_A = 0;            ///< −z at record_radius_A
  double conjugate_depth_A = 0;  ///< Σ p_i (−z_i) of the load pattern
  double force_eV_per_A = 0;
  double energy_eV = 0;          ///< relaxed energy relative to the flat, prestressed sheet
  double relative_residual = 0;  ///< |free residual| / |applied load|: at most 1e-8, or rounding where the
                                 ///< depth is below some 1e-4 of the radius
  /// Largest principal membrane force (second Piola–Kirchhoff) in the rim's triangles.
  double rim_membrane_force_eV_per_A2 = 0;
  int newton_iterations = 0;
};

struct Report {
  bool converged = false;  ///< every level reached
  std::string reason;      ///< why the path ended
  int triangles = 0;       ///< of the mesh that was solved
  int factorisations = 0;
  int assemblies = 0;
};

/// Called after each level; returning false ends the path.
using OnStep = std::function<bool(const Step&)>;

/// Follows the levels from the flat sheet. Throws std::invalid_argument for a problem that makes no sense
/// (named member, value, what is allowed); not converging is reported, not thrown.
Report solve(const Problem& problem, const OnStep& on_step);

}  // namespace membrane
