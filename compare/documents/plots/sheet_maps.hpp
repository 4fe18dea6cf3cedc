// A solved sheet seen from above: its stresses, its wrinkled zones and their tension rays.
#pragma once

#include "compare/documents/plots/plot.hpp"
#include "compare/results/sheet_columns.hpp"

namespace validate {

/// Three panels over the deformed sheet: larger and smaller principal Cauchy stress, and the states with tension rays
/// in wrinkled triangles. A quarter is drawn with its mirror images.
Plot sheet_plot(const SheetPicture& picture);

enum class SeenOver { deformed, flat };

/// A column of the triangles as a map over the deformed or the flat sheet.
TriangleMap triangle_map(const SheetPicture& picture, const std::string& name, const std::string& key,
                         SeenOver over = SeenOver::deformed);

/// The same in bands of equal value: those of the nodes, each the mean of its triangles by area. The steps from
/// triangle to triangle, which are the mesh's, are gone.
TriangleMap recovered_map(const SheetPicture& picture, const std::string& name, const std::string& key,
                          SeenOver over = SeenOver::deformed);

/// A quantity of the triangles at the nodes: the mean of those around, by area.
std::vector<double> at_nodes(const SheetPicture& picture, const std::vector<double>& of_triangles);

/// Puts the deformed sheet's heights to a map: it is then seen obliquely.
void raise(TriangleMap& map, const SheetPicture& picture);

/// Strokes along the tension of wrinkled triangles, thinned out to about fourteen a direction of a quarter.
PlotCurve tension_rays(const SheetPicture& picture, SeenOver over);

/// Where a node is, and a triangle's middle.
Eigen::Vector2d place_of(const SheetPicture& picture, int node, SeenOver over);
Eigen::Vector2d middle_of(const SheetPicture& picture, std::size_t triangle, SeenOver over);

/// Axes x and y of a square about the origin, and how colours say states (0 taut, 1 wrinkled, 2 slack).
Panel seen_from_above(const std::string& title, double half_side_A);
ColourScale scale_of_states();

}  // namespace validate
