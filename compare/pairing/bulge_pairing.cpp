#include "compare/pairing/bulge_pairing.hpp"

#include <cmath>
#include <stdexcept>

#include "compare/base/errors.hpp"
#include "compare/pairing/pairing.hpp"

namespace validate {
namespace {

/// The slope clamp of the discrete bending energy lies this many bonds beyond the free sheet (see PairedSheet).
constexpr double clamp_margin_bonds = 0.75;

atomistic::Problem atoms_of(const BulgeCase& c, const atomistic::Potential& potential, const atomistic::Card& card) {
  atomistic::Problem problem;
  problem.potential = potential;
  problem.card = card;
  problem.radius_A = c.size_A / 2;
  problem.form = {.shape = c.shape == "disc" ? atomistic::Shape::disc : atomistic::Shape::square,
                  .edge = c.edge == "clamped" ? atomistic::Edge::clamped : atomistic::Edge::sliding};
  problem.biaxial_strain = c.pretension_eV_per_A2 * (1 - card.nu()) / card.sheet_modulus_eV_per_A2();
  problem.load = atomistic::PressureLoad{};
  problem.control = atomistic::Control::force;
  problem.levels = c.pressures_eV_per_A3;
  return problem;
}

atomistic::Sheet sheet_of(const atomistic::Problem& p) {
  try {
    return atomistic::make_sheet(p.radius_A, p.card.a0_A, p.biaxial_strain, p.potential.interaction_range_A, p.form);
  } catch (const std::invalid_argument& e) {
    throw bad_input("size: {} Å makes no sheet of atoms: {}", 2 * p.radius_A, e.what());
  }
}

/// Twice the mean distance from the axis of the outermost atoms, those of the sides across x and across y.
Eigen::Vector2d between_sliding_edges(const atomistic::Sheet& sheet) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero(), count = Eigen::Vector2d::Zero();
  for (int i = 0; i < sheet.free_atoms; ++i) {
    if (!sheet.slides[i]) continue;
    const Eigen::Vector2d place = sheet.position(i).head<2>().cwiseAbs();
    const int axis = place.x() > place.y() ? 0 : 1;
    sum[axis] += 2 * place[axis];
    count[axis] += 1;
  }
  return sum.cwiseQuotient(count);
}

/// Twice the mean radius of a sliding rim's atoms.
double across_sliding_rim(const atomistic::Sheet& sheet) {
  double sum = 0, count = 0;
  for (int i = 0; i < sheet.free_atoms; ++i)
    if (sheet.slides[i]) sum += 2 * sheet.position(i).head<2>().norm(), ++count;
  return sum / count;
}

Eigen::Vector2d membrane_size(const BulgeCase& c, const atomistic::Sheet& sheet) {
  if (c.edge == "clamped") return Eigen::Vector2d::Constant(c.size_A + 2 * clamp_margin_bonds * sheet.bond_A);
  return c.shape == "disc" ? Eigen::Vector2d::Constant(across_sliding_rim(sheet)) : between_sliding_edges(sheet);
}

membrane::Problem membrane_of(const BulgeCase& c, const atomistic::Card& card, const atomistic::Sheet& sheet,
                              const Eigen::Vector2d& size_A) {
  membrane::Problem problem = bulge_problem(c);
  problem.law = membrane::StVenantKirchhoff{card.sheet_modulus_eV_per_A2(), card.nu()};
  if (auto* disc = std::get_if<membrane::DiscSheet>(&problem.sheet)) {
    disc->radius_A = size_A.x() / 2;
    problem.record_radius_A = sheet.bond_A;
  }
  if (auto* rectangle = std::get_if<membrane::RectangleSheet>(&problem.sheet)) {
    rectangle->length_x_A = size_A.x();
    rectangle->length_y_A = size_A.y();
  }
  return problem;
}

membrane::axisymmetric::SheetProblem calibrated_disc(const BulgeCase& c, const PotentialCard& card,
                                                     const BulgePair& pair) {
  membrane::axisymmetric::SheetProblem problem;
  problem.radius_A = pair.size_A.x() / 2;
  problem.load = membrane::axisymmetric::PressureLoad{};
  problem.record_radius_A = pair.sheet.bond_A;
  problem.levels = c.pressures_eV_per_A3;
  set_calibrated(problem, *card.law, card.card.bending_modulus_eV(), 1 + pair.atoms.biaxial_strain);
  return problem;
}

}  // namespace

BulgePair pair_bulge(const BulgeCase& c, const PotentialCard& card) {
  BulgePair pair;
  pair.atoms = atoms_of(c, card.potential.potential, card.card);
  pair.sheet = sheet_of(pair.atoms);
  pair.size_A = membrane_size(c, pair.sheet);
  pair.membrane = membrane_of(c, card.card, pair.sheet, pair.size_A);
  if (card.law && c.shape == "disc" && c.edge == "clamped") {
    pair.calibrated = calibrated_disc(c, card, pair);
    pair.atoms.guides = guides_from(*pair.calibrated);
  }
  return pair;
}

}  // namespace validate
