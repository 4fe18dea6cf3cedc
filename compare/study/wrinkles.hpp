// Wrinkles around the axis of a round sheet, from the places of its atoms or nodes.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "atomistic/lattice/sheet.hpp"
#include "membrane/problem.hpp"

namespace validate {

/// A point of a deformed sheet: its place when flat, and its depth (Å).
struct SheetPoint {
  Eigen::Vector2d flat_A;
  double depth_A = 0;
};

/// The free atoms at these positions (3N, Å).
std::vector<SheetPoint> points_of(const atomistic::Sheet& sheet, const Eigen::VectorXd& positions);

/// The nodes of a mesh of triangles, a quarter's with their mirror images.
std::vector<SheetPoint> points_of(const membrane::Mesh& mesh, const membrane::TriangleShape& shape);

struct Wrinkles {
  int count = 0;            ///< around the axis; 0: none that are told from noise
  double wavelength_A = 0;  ///< where they are highest
  double amplitude_A = 0;   ///< there, half of crest to trough, of this many waves around
};

/// In rings a twentieth of the radius wide, from three tenths of it outwards: what is left of the depth when the ring's
/// round shape is taken away, as a power spectrum around the axis. The count is that of most power over all rings.
Wrinkles wrinkles_of(const std::vector<SheetPoint>& points, double radius_A);

}  // namespace validate
