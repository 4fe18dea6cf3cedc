#include "atomistic/sheet.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>
#include <tuple>

namespace atomistic {
namespace {

/// One honeycomb site: cell (i, j) and sublattice, so that neighbours follow from integers, not distances.
struct Site {
  int i, j, sublattice;
  double x, y;
  double radius() const { return std::hypot(x, y); }
};

/// Lattice vectors a(1, 0) and a(1/2, √3/2); the origin is the centre of a hexagon.
Site make_site(int i, int j, int sublattice, double a) {
  const double up = sublattice == 0 ? 1.0 / 3 : 2.0 / 3;  // fractional coordinates of the two atoms
  const double u = i + up, v = j + up;
  return {i, j, sublattice, a * (u + v / 2), a * v * std::numbers::sqrt3 / 2};
}

std::vector<Site> honeycomb_disc(double outer_radius, double a) {
  const int reach = static_cast<int>(std::ceil(outer_radius / a * 2 / std::numbers::sqrt3)) + 2;
  std::vector<Site> sites;
  for (int i = -reach; i <= reach; ++i)
    for (int j = -reach; j <= reach; ++j)
      for (int s : {0, 1})
        if (Site site = make_site(i, j, s, a); site.radius() <= outer_radius) sites.push_back(site);
  return sites;
}

std::array<std::array<int, 3>, 3> neighbour_cells(const Site& s) {
  if (s.sublattice == 0) return {{{s.i, s.j, 1}, {s.i - 1, s.j, 1}, {s.i, s.j - 1, 1}}};
  return {{{s.i, s.j, 0}, {s.i + 1, s.j, 0}, {s.i, s.j + 1, 0}}};
}

void connect(Sheet& sheet, const std::vector<Site>& sites) {
  std::map<std::array<int, 3>, int> index;
  for (int k = 0; k < sheet.atoms(); ++k) index[{sites[k].i, sites[k].j, sites[k].sublattice}] = k;
  sheet.neighbours.assign(sites.size(), {-1, -1, -1});
  for (int k = 0; k < sheet.atoms(); ++k) {
    const auto cells = neighbour_cells(sites[k]);
    for (int n = 0; n < 3; ++n)
      if (auto found = index.find(cells[n]); found != index.end()) {
        sheet.neighbours[k][n] = found->second;
        if (k < found->second && k < sheet.free_atoms) sheet.bonds.push_back({k, found->second});
      }
  }
}

}  // namespace

Sheet make_sheet(double radius_A, double a0_A, double biaxial_strain, double ring_width_A) {
  if (!(radius_A >= 3 * a0_A) || !(a0_A > 0) || !(ring_width_A > 0) || !(biaxial_strain > -0.1))
    throw std::invalid_argument("sheet: radius must be at least 3 lattice constants, ring width positive");
  const double a = a0_A * (1 + biaxial_strain);
  std::vector<Site> sites = honeycomb_disc(radius_A + ring_width_A, a);
  std::sort(sites.begin(), sites.end(), [&](const Site& p, const Site& q) {
    const bool p_clamped = p.radius() > radius_A, q_clamped = q.radius() > radius_A;
    return std::tie(p_clamped, p.i, p.j, p.sublattice) < std::tie(q_clamped, q.i, q.j, q.sublattice);
  });

  Sheet sheet;
  sheet.bond_A = a / std::numbers::sqrt3;
  sheet.radius_A = radius_A;
  sheet.positions.resize(3 * static_cast<Eigen::Index>(sites.size()));
  for (int k = 0; k < sheet.atoms(); ++k) {
    sheet.positions.segment<3>(3 * k) << sites[k].x, sites[k].y, 0.0;
    sheet.free_atoms += sites[k].radius() <= radius_A;
  }
  connect(sheet, sites);
  const std::vector<int> centre = atoms_within(sheet, 1.01 * sheet.bond_A);
  std::copy_n(centre.begin(), 6, sheet.hexagon.begin());
  return sheet;
}

std::vector<int> atoms_within(const Sheet& sheet, double radius_A) {
  std::vector<int> found;
  for (int k = 0; k < sheet.atoms(); ++k)
    if (sheet.position(k).head<2>().norm() <= radius_A) found.push_back(k);
  return found;
}

double longest_bond(const Sheet& sheet, const Eigen::VectorXd& positions) {
  double longest = 0;
  for (const auto& [i, j] : sheet.bonds)
    longest = std::max(longest, (positions.segment<3>(3 * i) - positions.segment<3>(3 * j)).norm());
  return longest;
}

}  // namespace atomistic
