// A pressurised square solved as a membrane, ready for the panels of figure 4.
#pragma once

#include <string>
#include <vector>

#include "compare/figures/paper_figure.hpp"
#include "compare/figures/stress_field.hpp"

namespace validate {

struct Square {
  membrane::Mesh mesh;
  std::vector<TriangleStress> field;  ///< over the thickness it was asked for
  Eigen::VectorXd displacements_A;
  double centre_depth_A = 0, volume_A3 = 0, energy_eV = 0;
  double pull_in_A = 0;  ///< how far the middle of an edge has come inwards, at most
  double wrinkled_share = 0;
};

/// The last level of a problem; throws std::runtime_error where it is not solved.
Square solve_square(const membrane::Problem& problem, double thickness_A);

/// The sides between a wrinkled triangle and one that is not, and those of wrinkled triangles on the edge of the sheet.
PlotCurve wrinkled_outline(const Square& square);

/// A map's panel without its field.
Panel square_panel(const std::string& title, const char* label);

/// A map of the triangles' values with the outline of the wrinkled zone.
Panel square_panel(const std::string& title, const char* label, const char* key, const Square& square,
                   double (*value)(const TriangleStress&));

}  // namespace validate
