// A flat piece of honeycomb as a graph: places and bonds, before anything is clamped or loaded.
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <vector>

namespace atomistic {

/// One atom: its place in the plane, its cell and sublattice (which order the atoms), its bonded atoms (−1:
/// none).
struct Site {
  Eigen::Vector2d place;
  std::array<int, 3> cell;  ///< i, j, sublattice
  std::array<int, 3> neighbours = {-1, -1, -1};

  int bonds() const;
};

using Honeycomb = std::vector<Site>;

/// All sites within `reach` of the axis for which `inside(place)` holds, zigzag along x, turned by
/// rotation_deg. The axis goes through the centre of a hexagon, or through an atom. Places in Å.
Honeycomb honeycomb(double lattice_constant_A, double reach_A, bool atom_at_axis, double rotation_deg,
                    const std::function<bool(const Eigen::Vector2d&)>& inside);

/// Removes the sites for which `gone` is true and the bonds to them.
void remove_sites(Honeycomb& sites, const std::vector<bool>& gone);

/// Removes the atom nearest to the place.
void make_vacancy(Honeycomb& sites, const Eigen::Vector2d& place);

/// Turns the bond nearest to the place by 90° (Stone and Wales, Chem. Phys. Lett. 128 (1986) 501): its two
/// atoms exchange a neighbour each, four hexagons become two pentagons and two heptagons. Throws
/// std::invalid_argument where the bond's atoms do not have three neighbours each.
void make_stone_wales(Honeycomb& sites, const Eigen::Vector2d& place);

}  // namespace atomistic
