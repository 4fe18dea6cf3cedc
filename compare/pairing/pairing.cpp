#include "compare/pairing/pairing.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <variant>

#include "atomistic/loads/load_term.hpp"
#include "compare/base/errors.hpp"
#include "compare/base/nearest.hpp"
#include "compare/pairing/smooth_curve.hpp"
#include "compare/potential/law/states.hpp"

namespace validate {
namespace {

/// The paper's constants of its figure 2 (from its reference [30]).
constexpr double paper_E_eV_per_A3 = 5.864, paper_thickness_A = 1.37, paper_nu = 0.19;

membrane::Load disc_of(double radius_A) { return membrane::DiscLoad{radius_A}; }
membrane::Load sphere_of(double radius_A) { return membrane::SphereLoad{radius_A}; }

/// A load by its name, as each leaf knows it: the atoms', the membrane's of nominal radii, and the twin of the atoms.
/// Dead loads on N atoms have a disc of their area as twin, a rigid sphere the same sphere (its radius is to the atoms'
/// centres). `point` is the six atoms of the central hexagon, and one node of a membrane that has no atoms to match.
struct LoadPair {
  std::string_view name;
  atomistic::Load (*atoms)(double tip_A);
  membrane::Load (*nominal)(double tip_A);
  bool rigid;
};

constexpr std::array loads = {
    LoadPair{"point", [](double) -> atomistic::Load { return atomistic::PointLoad{}; },
             [](double) -> membrane::Load { return membrane::PointLoad{}; }, false},
    LoadPair{"disc", [](double tip) -> atomistic::Load { return atomistic::DiscLoad{tip}; }, disc_of, false},
    LoadPair{"sphere", [](double tip) -> atomistic::Load { return atomistic::SphereLoad{.radius_A = tip}; }, sphere_of,
             true},
};

const LoadPair& load_pair(std::string_view name) {
  for (const LoadPair& load : loads)
    if (load.name == name) return load;
  throw bad_input("unknown load '{}'", name);
}

std::vector<Eigen::Vector2d> places(const std::vector<double>& numbers) {
  std::vector<Eigen::Vector2d> all;
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) all.emplace_back(numbers[i], numbers[i + 1]);
  return all;
}

atomistic::SheetForm sheet_form(const Case& c) {
  return {.centre = c.centre == "atom" ? atomistic::Centre::atom : atomistic::Centre::hexagon,
          .rotation_deg = c.rotation_deg,
          .vacancies = places(c.vacancies_A),
          .stone_wales = places(c.stone_wales_A)};
}

/// The membrane's load that belongs to the atoms'.
membrane::Load twin_of(const Case& c, const PairedSheet& pair, const std::string& load) {
  const LoadPair& names = load_pair(load);
  return names.rigid ? names.nominal(c.tip_radius_A) : disc_of(pair.effective_tip_A(names.atoms(c.tip_radius_A)));
}

/// Of the loaded disc or the sphere; 0: a point.
double tip_radius_A(const membrane::Load& load) {
  if (const auto* disc = std::get_if<membrane::DiscLoad>(&load)) return disc->radius_A;
  const auto* sphere = std::get_if<membrane::SphereLoad>(&load);
  return sphere ? sphere->radius_A : 0.0;
}

bool dead_forces(const Case& c) { return !c.forces_eV_per_A.empty(); }

/// Membrane with its radii, constants and pretension; the case supplies the rest.
MembraneExperiment membrane_experiment(const Case& c, const std::string& load, const std::vector<double>& levels,
                                       Constants constants, double a_A, membrane::Load pattern, double Eh, double nu) {
  MembraneExperiment e;
  e.run.model = Model::membrane;
  e.run.load = load;
  e.run.constants = constants;
  e.run.a_A = a_A;
  e.run.tip_A = tip_radius_A(pattern);
  e.run.Eh_eV_per_A2 = Eh;
  e.run.nu = nu;
  e.run.pretension_eV_per_A2 = c.pretension_eV_per_A2;
  e.problem.sheet = membrane::DiscSheet{a_A};
  e.problem.law = membrane::StVenantKirchhoff{Eh, nu};
  e.problem.prestress_eV_per_A2 = c.pretension_eV_per_A2 * Eigen::Matrix2d::Identity();
  e.problem.load = pattern;
  e.problem.control = dead_forces(c) ? membrane::Control::force : membrane::Control::conjugate_depth;
  e.problem.levels = levels;
  return e;
}

/// σ0h (1 − ν) / (E h): the biaxial strain that causes the pretension.
double pretension_strain(const Case& c, const atomistic::Card& card) {
  return c.pretension_eV_per_A2 * (1 - card.nu()) / card.sheet_modulus_eV_per_A2();
}

}  // namespace

PairedSheet::PairedSheet(const Case& c, const atomistic::Potential& potential, const atomistic::Card& card)
    : strain_(pretension_strain(c, card)),
      sheet_(atomistic::make_sheet(c.radius_A, card.a0_A, strain_, potential.interaction_range_A, sheet_form(c))) {}

double PairedSheet::effective_tip_A(const atomistic::Load& load) const {
  const double loaded = static_cast<double>(atomistic::loaded_atoms(load, sheet_).size());
  const double atom_area = 0.75 * std::numbers::sqrt3 * sheet_.bond_A * sheet_.bond_A;
  return std::sqrt(loaded * atom_area / std::numbers::pi);
}

atomistic::Load atomistic_load(const Case& c, const std::string& load) { return load_pair(load).atoms(c.tip_radius_A); }

AtomisticExperiment atomistic_experiment(const Case& c, const atomistic::Potential& potential,
                                         const atomistic::Card& card, const PairedSheet& pair, const std::string& load,
                                         const std::vector<double>& levels) {
  AtomisticExperiment e;
  e.problem.potential = potential;
  e.problem.card = card;
  e.problem.radius_A = c.radius_A;
  e.problem.form = pair.sheet().form;
  e.problem.biaxial_strain = pair.biaxial_strain();
  e.problem.unload = c.unloading;
  e.problem.load = atomistic_load(c, load);
  e.problem.control = dead_forces(c) ? atomistic::Control::force : atomistic::Control::conjugate_depth;
  e.problem.levels = levels;
  e.problem.force_tolerance_eV_per_A = c.force_tolerance_eV_per_A;
  e.problem.past_artefact = c.past_artefact;
  e.run.model = Model::atomistic;
  e.run.load = load;
  e.run.a_A = pair.effective_radius_A();
  e.run.tip_A = tip_radius_A(twin_of(c, pair, load));
  e.run.Eh_eV_per_A2 = card.sheet_modulus_eV_per_A2();
  e.run.nu = card.nu();
  e.run.pretension_eV_per_A2 = c.pretension_eV_per_A2;
  e.run.record_radius_A = pair.sheet().bond_A;
  return e;
}

MembraneExperiment card_membrane(const Case& c, const atomistic::Card& card, const PairedSheet& pair,
                                 const std::string& load, const std::vector<double>& levels) {
  MembraneExperiment e = membrane_experiment(c, load, levels, Constants::card, pair.effective_radius_A(),
                                             twin_of(c, pair, load), card.sheet_modulus_eV_per_A2(), card.nu());
  e.run.record_radius_A = pair.sheet().bond_A;
  e.problem.record_radius_A = pair.sheet().bond_A;  // where the atoms' depth of record is taken
  return e;
}

MembraneExperiment paper_membrane(const Case& c, const std::string& load, const std::vector<double>& levels) {
  MembraneExperiment e =
      membrane_experiment(c, load, levels, Constants::paper, c.radius_A, load_pair(load).nominal(c.tip_radius_A),
                          paper_E_eV_per_A3 * paper_thickness_A, paper_nu);
  e.thickness_A = paper_thickness_A;
  return e;
}

MembraneExperiment given_membrane(const Case& c, const std::string& load, const std::vector<double>& levels) {
  MembraneExperiment e =
      membrane_experiment(c, load, levels, Constants::given, c.radius_A, load_pair(load).nominal(c.tip_radius_A),
                          *c.E_eV_per_A3 * *c.thickness_A, *c.nu);
  e.thickness_A = *c.thickness_A;
  return e;
}

namespace {

namespace axi = membrane::axisymmetric;

axi::Load in_one_dimension(const membrane::Load& load) {
  if (const auto* disc = std::get_if<membrane::DiscLoad>(&load)) return axi::DiscLoad{disc->radius_A};
  if (const auto* sphere = std::get_if<membrane::SphereLoad>(&load)) return axi::SphereLoad{sphere->radius_A};
  return axi::PointLoad{};
}

SheetExperiment sheet_experiment(const Case& c, const std::string& load, const std::vector<double>& levels,
                                 const PairedSheet& pair, const atomistic::Card& card, Model model,
                                 Constants constants) {
  SheetExperiment e;
  e.run.model = model;
  e.run.load = load;
  e.run.constants = constants;
  e.run.a_A = pair.effective_radius_A();
  e.run.tip_A = tip_radius_A(twin_of(c, pair, load));
  e.run.Eh_eV_per_A2 = card.sheet_modulus_eV_per_A2();
  e.run.nu = card.nu();
  e.run.pretension_eV_per_A2 = c.pretension_eV_per_A2;
  e.run.record_radius_A = pair.sheet().bond_A;
  e.problem.radius_A = e.run.a_A;
  e.problem.load = in_one_dimension(twin_of(c, pair, load));
  e.problem.pretension_eV_per_A2 = c.pretension_eV_per_A2;
  e.problem.record_radius_A = e.run.record_radius_A;
  e.problem.control = dead_forces(c) ? axi::Control::force : axi::Control::conjugate_depth;
  e.problem.levels = levels;
  if (model == Model::sheet) {
    e.problem.relaxed = false;
    e.problem.bending_modulus_eV = card.bending_modulus_eV();
  }
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

}  // namespace

void set_calibrated(axi::SheetProblem& problem, const CalibratedLaw& law, double bending_modulus_eV, double stretch) {
  const double strain = (stretch * stretch - 1) / 2;
  problem.law = prestretched(law.law, stretch);
  problem.pretension_eV_per_A2 = law.law({strain, strain, 0}).force_eV_per_A2[0];
  problem.bending_modulus_eV = bending_modulus_eV / (stretch * stretch);
  problem.relaxed = !(bending_modulus_eV > 0);
}

SheetExperiment calibrated_experiment(const Case& c, const atomistic::Card& card, const CalibratedLaw& law,
                                      const PairedSheet& pair, const std::string& load,
                                      const std::vector<double>& levels, Model model, double artefact_bond_A) {
  SheetExperiment e = sheet_experiment(c, load, levels, pair, card, model, Constants::calibrated);
  const double stretch = 1 + pair.biaxial_strain();
  set_calibrated(e.problem, law, e.problem.bending_modulus_eV, stretch);
  e.run.pretension_eV_per_A2 = e.problem.pretension_eV_per_A2;
  e.longest_bond = law.longest_bond;
  e.stretch = stretch;
  constexpr double beyond_A = 0.03;
  e.last_bond_A = artefact_bond_A + beyond_A;
  return e;
}

std::array<SheetExperiment, 3> plain_experiments(const Case& c, const atomistic::Card& card, const PairedSheet& pair,
                                                 const std::string& load, const std::vector<double>& levels) {
  const auto plain = [&](Model model) {
    SheetExperiment e = sheet_experiment(c, load, levels, pair, card, model, Constants::card);
    e.problem.law = membrane::StVenantKirchhoff{e.run.Eh_eV_per_A2, e.run.nu};
    return e;
  };
  std::array<SheetExperiment, 3> stages = {plain(Model::membrane), plain(Model::membrane), plain(Model::sheet)};
  stages[0].run.a_A = stages[0].problem.radius_A = c.radius_A;
  stages[0].problem.load = in_one_dimension(load_pair(load).nominal(c.tip_radius_A));
  return stages;
}

std::vector<atomistic::Guide> guides_from(const axi::SheetProblem& problem) {
  constexpr double spacing_A = 0.5;  // a third of a bond
  std::vector<atomistic::Guide> guides;
  axi::solve(problem, [&](const axi::SheetStep& step) {
    if (!step.converged) return false;
    std::vector<double> radius, outward, depth;
    for (const axi::SheetPoint& point : step.points) {
      radius.push_back(point.radius_A);
      outward.push_back(point.displacement_A);
      depth.push_back(point.depth_A);
    }
    const SmoothCurve u(radius, outward), w(radius, depth);
    atomistic::Guide guide{.level = problem.levels[static_cast<std::size_t>(step.level)],
                           .spacing_A = spacing_A,
                           .outward_A = {},
                           .depth_A = {}};
    for (int i = 0; i * spacing_A < radius.back(); ++i) {
      guide.outward_A.push_back(u.at(i * spacing_A));
      guide.depth_A.push_back(w.at(i * spacing_A));
    }
    guides.push_back(std::move(guide));
    return true;
  });
  return guides;
}

LawSummary summary_of(const CalibratedLaw& law, double bending_modulus_eV) {
  LawSummary summary{.degree = law.degree,
                     .rms_misfit = law.rms_misfit,
                     .worst_misfit = law.worst_misfit,
                     .anisotropy = law.anisotropy,
                     .longest_bond_A = longest_calibrated_bond_A,
                     .convex = law.convexity.convex(),
                     .bending_modulus_eV = bending_modulus_eV,
                     .power_of_I = {},
                     .power_of_q = {},
                     .coefficient_eV_per_A2 = {}};
  for (const membrane::InvariantTerm& term : law.law.terms) {
    summary.power_of_I.push_back(term.a);
    summary.power_of_q.push_back(term.b);
    summary.coefficient_eV_per_A2.push_back(term.coefficient_eV_per_A2);
  }
  return summary;
}

CardSummary summary_of(const atomistic::Card& card, double artefact_bond_A) {
  const double isotropic = (card.C11_eV_per_A2 - card.C12_eV_per_A2) / 2;
  return {.a0_A = card.a0_A,
          .energy_per_atom_eV = card.energy_per_atom_eV,
          .C11_eV_per_A2 = card.C11_eV_per_A2,
          .C12_eV_per_A2 = card.C12_eV_per_A2,
          .C66_eV_per_A2 = card.C66_eV_per_A2,
          .Eh_eV_per_A2 = card.sheet_modulus_eV_per_A2(),
          .nu = card.nu(),
          .bending_modulus_eV = card.bending_modulus_eV(),
          .isotropy_error = card.C66_eV_per_A2 / isotropic - 1,
          .artefact_bond_A = artefact_bond_A};
}

}  // namespace validate
