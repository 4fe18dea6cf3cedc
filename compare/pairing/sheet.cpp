#include "compare/pairing/sheet.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "atomistic/loads/load_term.hpp"
#include "compare/base/errors.hpp"

namespace validate {
namespace {

std::vector<Eigen::Vector2d> places(const std::vector<double>& numbers) {
  std::vector<Eigen::Vector2d> all;
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) all.emplace_back(numbers[i], numbers[i + 1]);
  return all;
}

atomistic::SheetForm sheet_form(const Case& c) {
  return {.shape = c.shape == Shape::square ? atomistic::Shape::square : atomistic::Shape::disc,
          .edge = c.edge == Edge::sliding ? atomistic::Edge::sliding : atomistic::Edge::clamped,
          .centre = c.centre == Centre::atom ? atomistic::Centre::atom : atomistic::Centre::hexagon,
          .rotation_deg = c.rotation_deg,
          .vacancies = places(c.vacancies_A),
          .stone_wales = places(c.stone_wales_A)};
}

/// σ0h (1 − ν) / (E h): the biaxial strain that causes the pretension.
double pretension_strain(const Case& c, const atomistic::Card& card) {
  return c.pretension_eV_per_A2 * (1 - card.nu()) / card.sheet_modulus_eV_per_A2();
}

atomistic::Sheet paired_sheet(const Case& c, const atomistic::Potential& potential, const atomistic::Card& card,
                              double strain) {
  try {
    return atomistic::make_sheet(c.radius_A, card.a0_A, strain, potential.interaction_range_A, sheet_form(c));
  } catch (const std::invalid_argument& e) {
    throw bad_input("{}: {} Å makes no sheet of atoms: {}", c.size_A ? "size" : "radius", c.size_A.value_or(c.radius_A),
                    e.what());
  }
}

/// The lattice without its defects: they take away no area.
atomistic::Sheet whole(const Case& c, const atomistic::Potential& potential, const atomistic::Card& card,
                       double strain) {
  Case perfect = c;
  perfect.vacancies_A.clear();
  perfect.stone_wales_A.clear();
  return paired_sheet(perfect, potential, card, strain);
}

double area_per_atom_A2(const atomistic::Sheet& sheet) {
  return 0.75 * std::numbers::sqrt3 * sheet.bond_A * sheet.bond_A;
}

/// Half lengths of the rectangle with the free atoms' area and ratio of second moments; of a disc its radius twice.
Eigen::Vector2d of_free_atoms(const atomistic::Sheet& sheet) {
  const double area = sheet.free_atoms * area_per_atom_A2(sheet);
  if (sheet.form.shape == atomistic::Shape::disc) return Eigen::Vector2d::Constant(std::sqrt(area / std::numbers::pi));
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  for (int i = 0; i < sheet.free_atoms; ++i) moment += sheet.position(i).head<2>().cwiseAbs2();
  const double ratio = std::sqrt(moment.x() / moment.y());
  return Eigen::Vector2d(std::sqrt(area * ratio), std::sqrt(area / ratio)) / 2;
}

/// Mean distance from the axis of the outermost atoms, those of the sides across x and across y.
Eigen::Vector2d to_sliding_edges(const atomistic::Sheet& sheet) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero(), count = Eigen::Vector2d::Zero();
  for (int i = 0; i < sheet.free_atoms; ++i) {
    if (!sheet.slides[static_cast<std::size_t>(i)]) continue;
    const Eigen::Vector2d place = sheet.position(i).head<2>().cwiseAbs();
    const int axis = place.x() > place.y() ? 0 : 1;
    sum[axis] += place[axis];
    count[axis] += 1;
  }
  return sum.cwiseQuotient(count);
}

/// Mean radius of a sliding rim's atoms.
double to_sliding_rim(const atomistic::Sheet& sheet) {
  double sum = 0, count = 0;
  for (int i = 0; i < sheet.free_atoms; ++i)
    if (sheet.slides[static_cast<std::size_t>(i)]) sum += sheet.position(i).head<2>().norm(), ++count;
  return sum / count;
}

}  // namespace

PairedSheet::PairedSheet(const Case& c, const atomistic::Potential& potential, const atomistic::Card& card)
    : strain_(pretension_strain(c, card)),
      sheet_(paired_sheet(c, potential, card, strain_)),
      slope_margin_A_(card.slope_margin_bonds * sheet_.bond_A) {
  if (c.edge == Edge::clamped)
    half_A_ =
        of_free_atoms(c.vacancies_A.empty() && c.stone_wales_A.empty() ? sheet_ : whole(c, potential, card, strain_))
            .array() +
        card.clamp_margin_bonds * sheet_.bond_A;
  else if (c.shape == Shape::disc)
    half_A_.setConstant(to_sliding_rim(sheet_));
  else
    half_A_ = to_sliding_edges(sheet_);
}

double PairedSheet::effective_tip_A(const atomistic::Load& load) const {
  const double loaded = static_cast<double>(atomistic::loaded_atoms(load, sheet_).size());
  return std::sqrt(loaded * area_per_atom_A2(sheet_) / std::numbers::pi);
}

}  // namespace validate
