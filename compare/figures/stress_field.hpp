// What a membrane's triangles bear at an equilibrium.
#pragma once

#include <array>
#include <vector>

#include "membrane/laws/tension_field.hpp"
#include "membrane/problem.hpp"

namespace validate {

struct TriangleStress {
  std::array<Eigen::Vector2d, 3> corners_A;            ///< in the reference
  double larger_eV_per_A3 = 0, smaller_eV_per_A3 = 0;  ///< principal Cauchy stresses for the thickness given
  membrane::SheetState state = membrane::SheetState::taut;
  Eigen::Vector2d direction = Eigen::Vector2d::Zero();  ///< of the larger one, in the reference: the rays of wrinkles
};

/// Of each triangle of the problem's mesh, in its order: membrane::fields_of as stresses over the thickness.
std::vector<TriangleStress> stress_field(const membrane::Problem& problem, const membrane::Mesh& mesh,
                                         double thickness_A, const Eigen::VectorXd& displacements_A);

}  // namespace validate
