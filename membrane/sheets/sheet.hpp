// The shapes a sheet can have: plain data, and the mesh that belongs to them.
#pragma once

#include <utility>
#include <variant>
#include <vector>

#include "membrane/sheets/mesh.hpp"

namespace membrane {

/// The part that is meshed. A quarter lies between the symmetry planes x = 0 and y = 0.
enum class Extent { quarter, full };

/// How rings follow each other from the centre to the rim: dense where a tip bends the surface, or all of one width.
enum class RingSpacing { graded, uniform };

/// Disc about the origin. Ring i of triangles, counted from the centre, holds 2 i − 1 of them in each sector; a quarter
/// is one sector, the full disc has six.
struct DiscSheet {
  double radius_A = 0;
  int rings = 72;
  Extent extent = Extent::quarter;
  RingSpacing spacing = RingSpacing::graded;
  Support rim = Support::clamped;
  /// Of a clamped rim of a meridian that bends: the rim turns by this length times its curvature, as if the slope were
  /// held that much farther out than displacements are. A lattice is clamped so. 0: the rim does not turn.
  double slope_margin_A = 0;
};

/// Ring between a hub and a rim, meshed whole: rings × 2 around triangles.
struct AnnulusSheet {
  double hub_radius_A = 0, radius_A = 0;
  int rings = 40;    ///< of quadrilaterals, two triangles each
  int around = 120;  ///< quadrilaterals in a ring
  Support hub = Support::clamped, rim = Support::clamped;
};

/// Rectangle about the origin, cells_x × cells_y × 2 triangles on the meshed part.
struct RectangleSheet {
  double length_x_A = 0, length_y_A = 0;  ///< of the full sheet
  int cells_x = 60, cells_y = 60;         ///< of the meshed part
  Extent extent = Extent::quarter;
  Support left = Support::sliding, right = Support::sliding;  ///< of the full sheet; a quarter has right and top only
  Support bottom = Support::sliding, top = Support::sliding;
  double edge_grading = 1;  ///< widest cell over the narrowest, which lie at the edges and so in the corners
};

using Sheet = std::variant<DiscSheet, AnnulusSheet, RectangleSheet>;

/// The paper's mesh of its circular sheet: a quarter of 44 equal rings, 1936 triangles.
DiscSheet paper_disc(double radius_A);

/// The paper's mesh of its pressurised square: 7200 triangles on the full sheet, edges held in their plane only.
RectangleSheet paper_square(double side_A);

/// Circles about the origin on which a round sheet shall have a ring of nodes, Å; 0: none.
struct MeshDemand {
  double load_radius_A = 0;
  double record_radius_A = 0;  ///< left out where the load's edge is too close
  double layer_A =
      0;  ///< of a sheet that bends: the shortest length over which it does, at its rim and the load's edge
  bool at_point = false;  ///< the load is on the centre itself
};

/// Throws std::invalid_argument where the sheet makes no sense (named member, value, what is allowed).
void check(const Sheet& sheet);

/// The mesh of a sheet that check() accepts. Throws std::invalid_argument where rings are so thin that chords of one
/// cross the next inside.
Mesh make_mesh(const Sheet& sheet, const MeshDemand& demand = {});

/// The edges of the part that is meshed, each with its support.
std::vector<std::pair<Edge, Support>> supports_of(const Sheet& sheet);

/// Whether a quarter between symmetry planes is meshed.
bool is_quarter(const Sheet& sheet);

/// Half the smallest extent, Å: how far out something that rests on the sheet may reach.
double inner_radius_A(const Sheet& sheet);

}  // namespace membrane
