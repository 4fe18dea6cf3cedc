// What a solved sheet looks like inside: state, strain, forces and stresses of every triangle.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "membrane/laws/tension_field.hpp"
#include "membrane/problem.hpp"

namespace membrane {

/// One value a triangle, in the mesh's order. Principal values are ordered, first ≥ second; directions are those of the
/// first, as an angle from the x axis of the reference sheet (radians, in (−π/2, π/2]).
struct SheetFields {
  std::vector<SheetState> state;                             ///< taut everywhere for an unrelaxed sheet
  std::vector<Voigt> strain;                                 ///< Green–Lagrange [E11, E22, 2 E12]
  std::vector<double> force_1_eV_per_A2, force_2_eV_per_A2;  ///< second Piola–Kirchhoff × thickness
  std::vector<double> direction_rad;                         ///< of force_1: along the wrinkles
  /// Cauchy stress × reference thickness, with the thickness and width conventions of laws/cauchy.hpp: over the
  /// thickness they are the principal Cauchy stresses.
  std::vector<double> cauchy_1_eV_per_A2, cauchy_2_eV_per_A2;
  double wrinkled_area_fraction = 0, slack_area_fraction = 0;  ///< of the reference area
};

/// Fields of this problem's sheet at a step's displacements; mesh is mesh_of(problem).
SheetFields fields_of(const Problem& problem, const Mesh& mesh, const Eigen::VectorXd& displacements_A);

}  // namespace membrane
