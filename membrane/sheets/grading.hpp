// Where the rings of a disc go: dense where the surface bends, an edge exactly on the load's radius.
#pragma once

#include <vector>

namespace membrane {

/// What the ring radii of a disc must respect, Å.
struct RingDemand {
  double sheet_radius_A = 0;
  double load_radius_A = 0;    ///< 0: point load; otherwise some ring lies exactly here
  double record_radius_A = 0;  ///< 0: none; otherwise a ring lies here too, unless the load's edge is too close
  int rings = 0;               ///< at least fewest_rings
  double layer_A = 0;     ///< 0: a membrane; otherwise √(κ/E·h), the shortest length over which the sheet bends
  bool at_point = false;  ///< the load is on the centre itself
};

inline constexpr int fewest_rings = 8;

/// Radii r_0 = 0 < r_1 < … < r_rings = sheet radius, Å.
///
/// Ring widths h(r) make every ring's share of the error equal. In a membrane pulled by a tip w' ~ r^(−1/3)
/// and N_r ~ r^(−2/3); linear elements err in energy by ∫ h² w''² N_r r dr, least for h ~ r^(7/9), i.e. r ~
/// s^4.5 in the ring number s. Under a disc load the slope is about linear up to the edge: constant h inside
/// and r^(7/9) outside.
///
/// A sheet that bends is smooth but for its layers at the rim and at the load's edge, which want short segments as much
/// as narrow rings: rings narrower than half their segments err more than equal ones do (a pressurised graphene disc of
/// 110 Å, 72 rings: 0.6 % in volume with equal rings, 0.9 % if those at the rim are half as wide). So h is about the
/// same all over, and less only under the load or at the point that bears it.
std::vector<double> graded_radii(const RingDemand& demand);

/// Rings of one width, apart from those next to the load's edge and the record radius, to which the nearest ring moves.
std::vector<double> uniform_radii(const RingDemand& demand);

}  // namespace membrane
