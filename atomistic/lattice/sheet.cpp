#include "atomistic/lattice/sheet.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <tuple>

#include "atomistic/lattice/honeycomb.hpp"

namespace atomistic {
namespace {

using Eigen::Vector2d;

/// How far out a place is, in the measure of the shape: the edge of the free sheet is at its radius.
double measure(Shape shape, const Vector2d& place) {
  return shape == Shape::disc ? place.norm() : place.cwiseAbs().maxCoeff();
}

/// Atoms that hang by one bond or none would swing freely: they are not part of the sheet.
void remove_dangling(Honeycomb& sites) {
  for (;;) {
    std::vector<bool> gone(sites.size());
    std::transform(sites.begin(), sites.end(), gone.begin(), [](const Site& s) { return s.bonds() < 2; });
    if (std::find(gone.begin(), gone.end(), true) == gone.end()) return;
    remove_sites(sites, gone);
  }
}

void add_defects(Honeycomb& sites, const SheetForm& form, double radius_A) {
  const auto inside = [&](const Vector2d& place) {
    if (!(measure(form.shape, place) < radius_A))
      throw std::invalid_argument("sheet: a defect lies outside the free sheet");
  };
  for (const Vector2d& place : form.stone_wales) inside(place), make_stone_wales(sites, place);
  for (const Vector2d& place : form.vacancies) inside(place), make_vacancy(sites, place);
  if (!form.vacancies.empty()) remove_dangling(sites);
}

/// Order of the atoms: free ones first, then by cell. Neighbours follow.
Honeycomb sorted(const Honeycomb& sites, const std::vector<bool>& clamped) {
  std::vector<int> order(sites.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = static_cast<int>(k);
  std::sort(order.begin(), order.end(), [&](int p, int q) {
    return std::make_tuple(bool(clamped[p]), sites[p].cell) < std::make_tuple(bool(clamped[q]), sites[q].cell);
  });
  std::vector<int> new_index(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) new_index[order[k]] = static_cast<int>(k);
  Honeycomb result;
  for (int k : order) {
    result.push_back(sites[k]);
    for (int& n : result.back().neighbours)
      if (n >= 0) n = new_index[n];
  }
  return result;
}

std::vector<int> free_atoms_within(const Sheet& sheet, double radius_A) {
  std::vector<int> atoms = atoms_within(sheet, radius_A);
  std::erase_if(atoms, [&](int atom) { return atom >= sheet.free_atoms; });
  return atoms;
}

void find_centre(Sheet& sheet) {
  sheet.record = free_atoms_within(sheet, 1.01 * sheet.bond_A);
  if (sheet.form.centre == Centre::atom) {
    sheet.innermost = free_atoms_within(sheet, 0.3 * sheet.bond_A);
    std::erase_if(sheet.record, [&](int atom) { return sheet.position(atom).norm() < 0.3 * sheet.bond_A; });
  } else {
    sheet.innermost = sheet.record;
  }
  if (sheet.record.empty() || sheet.innermost.empty())
    throw std::invalid_argument("sheet: no atom is left at the axis, where force and depth are taken");
}

Sheet finished(const Honeycomb& sites, int free_atoms, double bond_A, double radius_A, const SheetForm& form) {
  Sheet sheet;
  sheet.bond_A = bond_A;
  sheet.radius_A = radius_A;
  sheet.form = form;
  sheet.free_atoms = free_atoms;
  sheet.positions.setZero(3 * static_cast<Eigen::Index>(sites.size()));
  for (int k = 0; k < sheet.atoms(); ++k) {
    sheet.positions.segment<2>(3 * k) = sites[k].place;
    sheet.neighbours.push_back(sites[k].neighbours);
    if (k < free_atoms)
      for (int n : sites[k].neighbours)
        if (k < n) sheet.bonds.push_back({k, n});
  }
  find_centre(sheet);
  return sheet;
}

}  // namespace

Sheet make_sheet(double radius_A, double a0_A, double biaxial_strain, double ring_width_A, const SheetForm& form) {
  if (!(radius_A >= 3 * a0_A) || !(a0_A > 0) || !(ring_width_A > 0) || !(biaxial_strain > -0.1) ||
      !std::isfinite(form.rotation_deg))
    throw std::invalid_argument("sheet: radius must be at least 3 lattice constants, ring width positive");
  const double a = a0_A * (1 + biaxial_strain);
  const bool clamped_edge = form.edge == Edge::clamped;
  const double outer = radius_A + (clamped_edge ? ring_width_A : 0.0);
  const double reach = form.shape == Shape::disc ? outer : outer * std::numbers::sqrt2;
  Honeycomb sites = honeycomb(a, reach, form.centre == Centre::atom, form.rotation_deg,
                              [&](const Vector2d& place) { return measure(form.shape, place) <= outer; });
  if (!clamped_edge) remove_dangling(sites);
  std::vector<Vector2d> edge;  // found before vacancies make edges of their own
  if (!clamped_edge)
    for (const Site& site : sites)
      if (site.bonds() < 3) edge.push_back(site.place);
  add_defects(sites, form, radius_A);

  std::vector<bool> clamped(sites.size());
  std::transform(sites.begin(), sites.end(), clamped.begin(),
                 [&](const Site& s) { return measure(form.shape, s.place) > radius_A; });
  sites = sorted(sites, clamped);
  const int free_atoms = static_cast<int>(std::count(clamped.begin(), clamped.end(), false));
  Sheet sheet = finished(sites, free_atoms, a / std::numbers::sqrt3, radius_A, form);
  if (!edge.empty()) {
    const auto before = [](const Vector2d& p, const Vector2d& q) {
      return std::tie(p.x(), p.y()) < std::tie(q.x(), q.y());
    };
    std::sort(edge.begin(), edge.end(), before);
    for (const Site& site : sites)
      sheet.slides.push_back(std::binary_search(edge.begin(), edge.end(), site.place, before));
  }
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
