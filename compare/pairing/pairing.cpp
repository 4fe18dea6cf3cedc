#include "compare/pairing/pairing.hpp"

#include <algorithm>
#include <cmath>

#include "compare/base/paper.hpp"
#include "compare/pairing/loads.hpp"

namespace validate {
namespace {

/// The sheet that a membrane is meshed on, for half lengths (of a disc: its radius twice). Under an indenter a disc's
/// rings are narrow at the tip, under a pressure they are even.
membrane::Sheet membrane_sheet(const Case& c, LoadKind load, const Eigen::Vector2d& half_A) {
  const auto support = c.edge == Edge::sliding ? membrane::Support::sliding : membrane::Support::clamped;
  const auto extent = c.extent == Extent::quarter ? membrane::Extent::quarter : membrane::Extent::full;
  constexpr int default_cells = 60;
  if (c.shape == Shape::square) {
    const int cells = static_cast<int>(c.cells.value_or(default_cells));
    return membrane::RectangleSheet{.length_x_A = 2 * half_A.x(),
                                    .length_y_A = 2 * half_A.y(),
                                    .cells_x = cells,
                                    .cells_y = cells,
                                    .extent = extent,
                                    .left = support,
                                    .right = support,
                                    .bottom = support,
                                    .top = support};
  }
  membrane::DiscSheet disc{.radius_A = half_A.x(), .extent = extent, .rim = support};
  if (load == LoadKind::pressure) {
    disc.rings = default_cells;
    disc.spacing = membrane::RingSpacing::uniform;
  }
  if (c.cells) disc.rings = static_cast<int>(*c.cells);
  return disc;
}

/// A named law with the constants of the run.
void take_law(const MembraneLaw& law, ContinuumExperiment& e) {
  e.run.law = law.name;
  e.problem.law = law_of(law, e.run.Eh_eV_per_A2, e.run.nu);
}

/// A rim that slides under its dead tension.
void pull_rim(const Case& c, ContinuumExperiment& e) {
  if (!has_pulled_rim(c)) return;
  e.run.rim_tension_eV_per_A2 = e.problem.edge_tension_eV_per_A2 = *c.rim_tension_eV_per_A2;
  e.run.compression = e.problem.relaxed ? Compression::relieved : Compression::borne;
}

/// The same sheet, round and not relaxed: triangles without bending would fold as finely as they can.
ContinuumExperiment bearing_compression(const Case& c, ContinuumExperiment e) {
  e.purpose = Purpose::compression_borne;
  e.problem.discretisation = membrane::Meridian{};
  e.problem.sheet = membrane::DiscSheet{.radius_A = e.run.a_A, .rim = membrane::Support::sliding};
  e.problem.relaxed = false;
  pull_rim(c, e);
  return e;
}

/// Under a pulled rim the tension field and, beside it, the sheet that bears compression, or the one that is asked for.
std::vector<ContinuumExperiment> with_compression(const Case& c, ContinuumExperiment e) {
  if (!has_pulled_rim(c) || c.relaxed) return {std::move(e)};
  if (c.unrelaxed) return {bearing_compression(c, std::move(e))};
  return {e, bearing_compression(c, e)};
}

/// Membrane of the paper's law with its half lengths, constants and pretension; the case supplies the rest.
ContinuumExperiment plain_membrane(const Case& c, LoadKind load, Purpose purpose, Constants constants,
                                   const Eigen::Vector2d& half_A, membrane::Load pattern, double Eh, double nu) {
  ContinuumExperiment e;
  e.purpose = purpose;
  e.run.model = Model::membrane;
  e.run.load = load;
  e.run.constants = constants;
  e.run.a_A = half_A.x();
  e.run.tip_A = tip_radius_A(pattern);
  e.run.Eh_eV_per_A2 = Eh;
  e.run.nu = nu;
  e.run.pretension_eV_per_A2 = c.pretension_eV_per_A2;
  membrane::Problem& problem = e.problem;
  problem.sheet = membrane_sheet(c, load, half_A);
  take_law({}, e);
  problem.prestress_eV_per_A2 = c.pretension_eV_per_A2 * Eigen::Matrix2d::Identity();
  problem.relaxed = !c.unrelaxed;
  problem.load = pattern;
  problem.control = prescribes_force(c, load) ? membrane::Control::force : membrane::Control::conjugate_depth;
  pull_rim(c, e);
  return e;
}

ContinuumExperiment like_for_like(const Case& c, const Material& m, LoadKind load) {
  ContinuumExperiment e =
      plain_membrane(c, load, Purpose::like_for_like, Constants::card, m.sheet.half_A(), twin_of(c, m.sheet, load),
                     m.card.card.sheet_modulus_eV_per_A2(), m.card.card.nu());
  // A square's grid has no circle to take the depth at, and one bond is next to nothing there.
  if (c.shape == Shape::disc) e.run.record_radius_A = e.problem.record_radius_A = m.sheet.sheet().bond_A;
  e.thickness_A = c.thickness_A.value_or(graphite_spacing_A);
  take_law(c.law, e);
  return e;
}

ContinuumExperiment paper_membrane(const Case& c, LoadKind load) {
  ContinuumExperiment e =
      plain_membrane(c, load, Purpose::paper, Constants::paper, Eigen::Vector2d::Constant(c.radius_A),
                     nominal_load(c, load), paper::E_eV_per_A3 * paper::thickness_A, paper::nu);
  e.thickness_A = paper::thickness_A;
  return e;
}

ContinuumExperiment given_membrane(const Case& c, LoadKind load) {
  ContinuumExperiment e =
      plain_membrane(c, load, Purpose::given, Constants::given, Eigen::Vector2d::Constant(c.radius_A),
                     nominal_load(c, load), *c.E_eV_per_A3 * *c.thickness_A, *c.nu);
  e.thickness_A = *c.thickness_A;
  take_law(c.law, e);
  return e;
}

/// A rim that slides under its tension. A membrane stays in one dimension; a sheet that bends wrinkles as it likes, on
/// triangles: a quarter has the waves whose number around is even.
void let_slide(const Case& c, ContinuumExperiment& e) {
  constexpr int rings = 40;
  membrane::DiscSheet disc{.radius_A = e.run.a_A, .rim = membrane::Support::sliding};
  if (e.run.model == Model::sheet) {
    e.problem.discretisation = membrane::Triangles{};
    disc.rings = c.cells ? static_cast<int>(*c.cells) : rings;
    disc.extent = c.extent == Extent::full ? membrane::Extent::full : membrane::Extent::quarter;
    e.problem.bending->gaussian_eV = -e.problem.bending->mean_eV;
  }
  e.problem.sheet = disc;
  pull_rim(c, e);
}

/// A clamped disc in one dimension on the atoms' radii, its law still missing.
ContinuumExperiment round_sheet(const Case& c, const Material& m, LoadKind load, Purpose purpose, Model model,
                                Constants constants) {
  const atomistic::Card& card = m.card.card;
  ContinuumExperiment e;
  e.purpose = purpose;
  e.run.model = model;
  e.run.load = load;
  e.run.constants = constants;
  e.run.a_A = m.sheet.effective_radius_A();
  e.run.tip_A = tip_radius_A(twin_of(c, m.sheet, load));
  e.run.Eh_eV_per_A2 = card.sheet_modulus_eV_per_A2();
  e.run.nu = card.nu();
  e.run.pretension_eV_per_A2 = c.pretension_eV_per_A2;
  e.run.record_radius_A = m.sheet.sheet().bond_A;
  e.problem.discretisation = membrane::Meridian{};
  e.problem.sheet = membrane::DiscSheet{e.run.a_A};
  e.problem.load = twin_of(c, m.sheet, load);
  e.problem.prestress_eV_per_A2 = c.pretension_eV_per_A2 * Eigen::Matrix2d::Identity();
  e.problem.record_radius_A = e.run.record_radius_A;
  e.problem.control = prescribes_force(c, load) ? membrane::Control::force : membrane::Control::conjugate_depth;
  if (model == Model::sheet) {
    e.problem.relaxed = false;
    e.problem.bending = membrane::clamped_all_round(card.bending_modulus_eV());
    std::get<membrane::DiscSheet>(e.problem.sheet).slope_margin_A = m.sheet.slope_margin_A();
  }
  if (has_pulled_rim(c)) let_slide(c, e);
  return e;
}

/// A law per area of the sheet that is stretched already, W(λ² Ē)/λ²: the prestress is then the law's answer to the
/// imposed strain, exactly.
membrane::CauchyBorn prestretched(membrane::CauchyBorn law, double stretch) {
  const double square = stretch * stretch;
  law.sheet_modulus_eV_per_A2 *= square;
  for (membrane::InvariantTerm& term : law.terms) term.coefficient_eV_per_A2 *= std::pow(square, term.a + term.b - 1);
  return law;
}

/// The curve ends a little beyond what the law is fitted to, where the artefact's beginning can be foretold.
ContinuumExperiment calibrated(const Case& c, const Material& m, LoadKind load, Purpose purpose, Model model) {
  constexpr double beyond_A = 0.05;
  const CalibratedLaw& law = *m.card.law;
  ContinuumExperiment e = round_sheet(c, m, load, purpose, model, Constants::calibrated);
  e.stretch = 1 + m.sheet.biaxial_strain();
  const double strain = (e.stretch * e.stretch - 1) / 2;
  e.run.pretension_eV_per_A2 = law.law({strain, strain, 0}).force_eV_per_A2[0];
  e.problem.law = prestretched(law.law, e.stretch);
  e.problem.prestress_eV_per_A2 = e.run.pretension_eV_per_A2 * Eigen::Matrix2d::Identity();
  if (model == Model::sheet && !has_pulled_rim(c))
    e.problem.bending = membrane::clamped_all_round(m.card.card.bending_modulus_eV() / (e.stretch * e.stretch));
  e.longest_bond = law.longest_bond;
  e.law_holds_to_A = law.range.holds_A;
  e.last_bond_A = law.range.fitted_A + beyond_A;
  return e;
}

ContinuumExperiment stage(const Case& c, const Material& m, LoadKind load, Purpose purpose) {
  const Model model = purpose == Purpose::bending ? Model::sheet : Model::membrane;
  ContinuumExperiment e = round_sheet(c, m, load, purpose, model, Constants::card);
  take_law({}, e);
  if (purpose != Purpose::nominal_radii) return e;
  e.run.a_A = c.radius_A;
  e.problem.sheet = membrane::DiscSheet{c.radius_A};
  e.problem.load = nominal_load(c, load);
  return e;
}

/// The potential's own law: on a disc that is clamped, in one dimension, or whose rim is pulled.
bool has_calibrated_sheet(const Case& c, const Material& m) {
  return m.card.law && c.shape == Shape::disc && (c.edge == Edge::clamped || has_pulled_rim(c));
}

/// Where wrinkles change the force: the tension field and what bears compression, of the paper's law and the
/// potential's.
std::vector<ContinuumExperiment> pulled_continua(const Case& c, const Material& m, LoadKind load) {
  std::vector<ContinuumExperiment> all = with_compression(c, like_for_like(c, m, load));
  if (!has_calibrated_sheet(c, m)) return all;
  all.push_back(calibrated(c, m, load, Purpose::calibrated_membrane, Model::membrane));
  all.push_back(calibrated(c, m, load, Purpose::calibrated_sheet, Model::sheet));
  return all;
}

/// Under a pressure the paper has no disc, and nothing is explained.
std::vector<ContinuumExperiment> continua(const Case& c, const Material& m, LoadKind load) {
  const bool pressed = load == LoadKind::pressure;
  if (has_pulled_rim(c)) return pulled_continua(c, m, load);
  std::vector<ContinuumExperiment> all = {like_for_like(c, m, load)};
  if (!pressed) all.push_back(paper_membrane(c, load));
  if (!has_calibrated_sheet(c, m)) return all;
  if (!pressed) all.push_back(calibrated(c, m, load, Purpose::calibrated_membrane, Model::membrane));
  all.push_back(calibrated(c, m, load, Purpose::calibrated_sheet, Model::sheet));
  if (!pressed)
    for (const Purpose purpose : {Purpose::nominal_radii, Purpose::paired_radii, Purpose::bending})
      all.push_back(stage(c, m, load, purpose));
  return all;
}

atomistic::Preconditioning preconditioning(Preconditioner asked) {
  switch (asked) {
    case Preconditioner::automatic:
      return atomistic::Preconditioning::automatic;
    case Preconditioner::factor:
      return atomistic::Preconditioning::factor;
    case Preconditioner::multigrid:
      return atomistic::Preconditioning::multigrid;
  }
  return {};
}

AtomisticExperiment atoms(const Case& c, const Material& m, LoadKind load) {
  AtomisticExperiment e;
  e.problem.potential = m.file.potential;
  e.problem.card = m.card.card;
  e.problem.radius_A = c.radius_A;
  e.problem.form = m.sheet.sheet().form;
  e.problem.biaxial_strain = m.sheet.biaxial_strain();
  e.problem.unload = c.unloading;
  e.problem.rim_tension_eV_per_A2 = c.rim_tension_eV_per_A2.value_or(0);
  e.problem.load = atoms_load(c, load);
  e.problem.control = prescribes_force(c, load) ? atomistic::Control::force : atomistic::Control::conjugate_depth;
  e.problem.force_tolerance_eV_per_A = c.force_tolerance_eV_per_A;
  e.problem.past_artefact = c.past_artefact;
  e.problem.preconditioning = preconditioning(c.preconditioner);
  e.run.model = Model::atomistic;
  settle_part(e.run);
  if (has_pulled_rim(c)) e.run.rim_tension_eV_per_A2 = *c.rim_tension_eV_per_A2;
  e.run.load = load;
  e.run.a_A = m.sheet.effective_radius_A();
  e.run.tip_A = tip_radius_A(twin_of(c, m.sheet, load));
  e.run.Eh_eV_per_A2 = m.card.card.sheet_modulus_eV_per_A2();
  e.run.nu = m.card.card.nu();
  e.run.pretension_eV_per_A2 = c.pretension_eV_per_A2;
  e.run.record_radius_A = m.sheet.sheet().bond_A;
  return e;
}

}  // namespace

const ContinuumExperiment* PairedLoad::find(Purpose purpose) const {
  const auto found = std::ranges::find(continua, purpose, &ContinuumExperiment::purpose);
  return found == continua.end() ? nullptr : &*found;
}

std::vector<PairedLoad> pair(const Case& c) {
  std::vector<PairedLoad> pairs;
  for (const LoadKind load : c.loads)
    pairs.push_back({load, std::nullopt, with_compression(c, given_membrane(c, load)), std::nullopt});
  return pairs;
}

std::vector<PairedLoad> pair(const Case& c, const Material& material) {
  std::vector<PairedLoad> pairs;
  for (const LoadKind load : c.loads) {
    PairedLoad one{load, std::nullopt, {}, std::nullopt};
    if (c.models != Models::membrane) {
      one.atoms = atoms(c, material, load);
      if (has_calibrated_sheet(c, material) && !has_pulled_rim(c) && c.vacancies_A.empty() && c.stone_wales_A.empty())
        one.guide = calibrated(c, material, load, Purpose::calibrated_sheet, Model::sheet);
    }
    if (c.models != Models::atomistic) one.continua = continua(c, material, load);
    pairs.push_back(std::move(one));
  }
  return pairs;
}

}  // namespace validate
