#include "atomistic/lattice/honeycomb.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>

namespace atomistic {
namespace {

using Eigen::Vector2d;

/// Lattice vectors a(1, 0) and a(1/2, √3/2); the origin is the centre of a hexagon.
Vector2d place_of(int i, int j, int sublattice, double a) {
  const double up = sublattice == 0 ? 1.0 / 3 : 2.0 / 3;  // fractional coordinates of the two atoms
  const double u = i + up, v = j + up;
  return {a * (u + v / 2), a * v * std::numbers::sqrt3 / 2};
}

/// Neighbours follow from integers, not from distances.
std::array<std::array<int, 3>, 3> neighbour_cells(const std::array<int, 3>& cell) {
  const auto [i, j, sublattice] = cell;
  if (sublattice == 0) return {{{i, j, 1}, {i - 1, j, 1}, {i, j - 1, 1}}};
  return {{{i, j, 0}, {i + 1, j, 0}, {i, j + 1, 0}}};
}

void connect(Honeycomb& sites) {
  std::map<std::array<int, 3>, int> index;
  for (std::size_t k = 0; k < sites.size(); ++k) index[sites[k].cell] = static_cast<int>(k);
  for (Site& site : sites) {
    const auto cells = neighbour_cells(site.cell);
    for (int n = 0; n < 3; ++n)
      if (const auto found = index.find(cells[n]); found != index.end()) site.neighbours[n] = found->second;
  }
}

int nearest_atom(const Honeycomb& sites, const Vector2d& place) {
  const auto distance = [&](const Site& s) { return (s.place - place).squaredNorm(); };
  const auto found = std::min_element(sites.begin(), sites.end(),
                                      [&](const Site& a, const Site& b) { return distance(a) < distance(b); });
  return static_cast<int>(found - sites.begin());
}

std::array<int, 2> nearest_bond(const Honeycomb& sites, const Vector2d& place) {
  std::array<int, 2> best = {-1, -1};
  double nearest = INFINITY;
  for (int i = 0; i < static_cast<int>(sites.size()); ++i)
    for (int j : sites[i].neighbours) {
      if (j < i) continue;
      const double distance = ((sites[i].place + sites[j].place) / 2 - place).squaredNorm();
      if (distance < nearest) nearest = distance, best = {i, j};
    }
  return best;
}

void replace_neighbour(Site& site, int old_one, int new_one) {
  *std::find(site.neighbours.begin(), site.neighbours.end(), old_one) = new_one;
}

/// The neighbour of `atom` other than `partner` that lies on the given side of the bond.
int neighbour_on(const Honeycomb& sites, int atom, int partner, const Vector2d& middle, const Vector2d& side) {
  int found = -1;
  for (int n : sites[atom].neighbours)
    if (n >= 0 && n != partner && (sites[n].place - middle).dot(side) > 0) found = n;
  if (found < 0) throw std::invalid_argument("Stone–Wales defect: its bond must be away from edges and vacancies");
  return found;
}

}  // namespace

int Site::bonds() const {
  return static_cast<int>(std::count_if(neighbours.begin(), neighbours.end(), [](int n) { return n >= 0; }));
}

Honeycomb honeycomb(double lattice_constant_A, double reach_A, bool atom_at_axis, double rotation_deg,
                    const std::function<bool(const Vector2d&)>& inside) {
  const double a = lattice_constant_A, angle = rotation_deg * std::numbers::pi / 180;
  const Eigen::Matrix2d turn{{std::cos(angle), -std::sin(angle)}, {std::sin(angle), std::cos(angle)}};
  const Vector2d axis = atom_at_axis ? place_of(0, 0, 0, a) : Vector2d(0, 0);
  const int cells = static_cast<int>(std::ceil(reach_A / a * 2 / std::numbers::sqrt3)) + 2;
  Honeycomb sites;
  for (int i = -cells; i <= cells; ++i)
    for (int j = -cells; j <= cells; ++j)
      for (int s : {0, 1}) {
        Vector2d place = place_of(i, j, s, a) - axis;
        if (rotation_deg != 0) place = turn * place;
        if (inside(place)) sites.push_back({place, {i, j, s}});
      }
  connect(sites);
  return sites;
}

void remove_sites(Honeycomb& sites, const std::vector<bool>& gone) {
  std::vector<int> new_index(sites.size(), -1);
  Honeycomb kept;
  for (std::size_t k = 0; k < sites.size(); ++k) {
    if (gone[k]) continue;
    new_index[k] = static_cast<int>(kept.size());
    kept.push_back(sites[k]);
  }
  for (Site& site : kept)
    for (int& n : site.neighbours)
      if (n >= 0) n = new_index[n];
  sites = std::move(kept);
}

void make_vacancy(Honeycomb& sites, const Vector2d& place) {
  std::vector<bool> gone(sites.size(), false);
  gone[nearest_atom(sites, place)] = true;
  remove_sites(sites, gone);
}

void make_stone_wales(Honeycomb& sites, const Vector2d& place) {
  const auto [i, j] = nearest_bond(sites, place);
  const Vector2d middle = (sites[i].place + sites[j].place) / 2, half = sites[i].place - middle;
  const Vector2d side(-half.y(), half.x());  // where atom i goes
  const int from_i = neighbour_on(sites, i, j, middle, -side), from_j = neighbour_on(sites, j, i, middle, side);
  neighbour_on(sites, i, j, middle, side);
  neighbour_on(sites, j, i, middle, -side);
  sites[i].place = middle + side;
  sites[j].place = middle - side;
  replace_neighbour(sites[i], from_i, from_j);
  replace_neighbour(sites[j], from_j, from_i);
  replace_neighbour(sites[from_i], i, j);
  replace_neighbour(sites[from_j], j, i);
}

}  // namespace atomistic
