#include "tests/compare/results/sample_result.hpp"

#include <cmath>

#include "compare/fitting/fit.hpp"
#include "compare/fitting/run_fit.hpp"
#include "compare/verdict/agreement.hpp"
#include "compare/verdict/explanation.hpp"

namespace sample {

using namespace validate;

namespace {

constexpr double artefact_bond_A = 1.70;
constexpr double a_A = 111.048, airebo_Eh = 17.33, airebo_nu = 0.3645;
constexpr double paper_Eh = 5.864 * 1.37;

double cubic(double stiffness, double Eh, double depth) { return stiffness * Eh * std::pow(depth, 3) / (a_A * a_A); }

CardSummary airebo_card() {
  CardSummary card;
  card.a0_A = 2.41924328;
  card.energy_per_atom_eV = -7.4;
  card.Eh_eV_per_A2 = airebo_Eh;
  card.nu = airebo_nu;
  card.C11_eV_per_A2 = airebo_Eh / (1 - airebo_nu * airebo_nu);
  card.C12_eV_per_A2 = airebo_nu * card.C11_eV_per_A2;
  card.C66_eV_per_A2 = (card.C11_eV_per_A2 - card.C12_eV_per_A2) / 2;
  card.bending_modulus_eV = 0.966;
  card.isotropy_error = 1e-6;
  card.artefact_bond_A = artefact_bond_A;
  return card;
}

Provenance provenance() {
  Provenance p;
  p.version = "0.1.0";
  p.git = "0123456";
  p.lammps = "29 Sep 2021 - Update 2";
  p.gsl = "2.7.1";
  p.hdf5 = "1.10.8";
  p.suitesparse = "5.12.0";
  p.blas = "/usr/lib/x86_64-linux-gnu/openblas-serial/libblas.so.3";
  p.potential_file = "/usr/share/lammps/potentials/CH.airebo";
  p.potential_sha256 = std::string(64, 'a');
  p.command_line = "validate indentation --radius 110";
  return p;
}

}  // namespace

Run atomistic_run(LoadKind load, double stiffness, double longest_bond_per_depth) {
  Run run;
  run.model = Model::atomistic;
  AtomsPart& part = run.part.emplace<AtomsPart>();
  run.load = load;
  run.a_A = a_A;
  run.tip_A = load == LoadKind::disc ? 10.2 : 1.7;
  run.Eh_eV_per_A2 = airebo_Eh;
  run.nu = airebo_nu;
  run.ended = Ended::depth_max;
  for (double depth = 2; depth <= 24; depth += 2) {
    const double bond = 1.397 + longest_bond_per_depth * depth;
    const double ratio = 1 + 0.25 * std::pow(0.038 * a_A / depth, 2) - 2.3 * std::pow(depth / a_A, 2);
    run.depth_A.push_back(depth);
    run.conjugate_depth_A.push_back(0.98 * depth);
    run.force_eV_per_A.push_back(ratio * cubic(stiffness, airebo_Eh, depth));
    run.energy_eV.push_back(run.force_eV_per_A.back() * depth / 4);
    run.converged.push_back(true);
    run.longest_bond_A.push_back(bond);
    part.artefact.push_back(bond >= artefact_bond_A);
    part.max_force_eV_per_A.push_back(8e-6);
    part.balance_relative.push_back(6e-4);
    part.force_error_relative.push_back(3e-5);
    part.force_evaluations.push_back(11);
    part.factorisations.push_back(1);
    part.solves.push_back(12);
    if (!part.artefact.back()) continue;
    run.ended = Ended::artefact;
    run.ended_reason = "longest bond 1.70 Å";
    break;
  }
  part.preconditioner = Preconditioner::factor;
  if (load == LoadKind::sphere) {
    part.contact = ContactSensitivity{0.0025, -0.02, 0.0009, 0.05};
    part.breaking = Breaking{.force_eV_per_A = 86.1,
                             .depth_A = 22,
                             .bracket = {86.1, 86.9},
                             .depth_bracket_A = {22, 22.2},
                             .past_artefact = false,
                             .sheet_force_eV_per_A = 83.4,
                             .sheet_depth_A = std::nullopt};
  }
  fit_run(run);
  return run;
}

Run membrane_run(LoadKind load, Constants constants, double stiffness) {
  Run run;
  run.load = load;
  run.constants = constants;
  run.a_A = constants == Constants::card ? a_A : 110;
  run.tip_A = load == LoadKind::disc ? 10 : 0;
  run.Eh_eV_per_A2 = constants == Constants::card ? airebo_Eh : paper_Eh;
  run.nu = constants == Constants::card ? airebo_nu : 0.19;
  run.ended = Ended::depth_max;
  run.ended_reason = "largest depth reached";
  run.continuum().triangles = 1936;
  for (double depth = 1; depth <= 25; depth += 2) {
    run.depth_A.push_back(depth);
    run.conjugate_depth_A.push_back(0.98 * depth);
    run.force_eV_per_A.push_back(cubic(stiffness, run.Eh_eV_per_A2, depth));
    run.energy_eV.push_back(run.force_eV_per_A.back() * depth / 4);
    run.converged.push_back(true);
    run.continuum().newton_iterations.push_back(5);
  }
  fit_run(run);
  return run;
}

namespace {

/// F = 1.45 E·h δ³/a² with the atoms' bending and softening: what the calibrated sheet is, nearly.
Run calibrated_run(Model model, LoadKind load, double stiffness, double bond_per_depth) {
  Run run = atomistic_run(load, stiffness, bond_per_depth);
  run.model = model;
  run.constants = Constants::calibrated;
  run.part.emplace<ContinuumPart>().newton_iterations.assign(run.depth_A.size(), 4);
  run.fits.clear();
  run.record_radius_A = 1.397;
  fit_run(run);
  return run;
}

LawSummary law() {
  LawSummary law;
  law.degree = 4;
  law.rms_misfit = 0.001;
  law.worst_misfit = 0.003;
  law.anisotropy = 0.08;
  law.longest_bond_A = 1.66;
  law.convex = true;
  law.bending_modulus_eV = 0.966;
  law.power_of_I = {3, 1, 0, 4};
  law.power_of_q = {0, 2, 3, 0};
  law.coefficient_eV_per_A2 = {-15.8, -20.1, -11.2, 3.4};
  law.coefficient_stderr_eV_per_A2 = {0.1, 0.2, 0.1, 0.3};
  return law;
}

}  // namespace

Result full() {
  Result result;
  result.law = law();
  result.sheet = SheetSummary{.radius_A = 110,
                              .effective_radius_A = a_A,
                              .slope_margin_A = 0.6,
                              .clamp_radius_error_A = 0.1,
                              .slope_margin_error_A = 0.1,
                              .tip_radius_error_A = 0.1,
                              .atoms = 17244,
                              .free_atoms = 15000,
                              .loaded_disc_atoms = 126};
  result.card = airebo_card();
  result.runs = {
      atomistic_run(LoadKind::point, 1.10, 0.0145),          atomistic_run(LoadKind::disc, 1.45, 0.0095),
      membrane_run(LoadKind::point, Constants::card, 1.08),  membrane_run(LoadKind::disc, Constants::card, 1.45),
      membrane_run(LoadKind::point, Constants::paper, 0.96), membrane_run(LoadKind::disc, Constants::paper, 1.35)};
  for (const double stiffness : {1.11, 1.452}) {
    const LoadKind load = stiffness < 1.2 ? LoadKind::point : LoadKind::disc;
    result.runs.push_back(
        calibrated_run(Model::membrane, load, 0.95 * stiffness, load == LoadKind::disc ? 0.0094 : 0.0143));
    result.runs.push_back(calibrated_run(Model::sheet, load, stiffness, load == LoadKind::disc ? 0.0096 : 0.0146));
  }
  const Run plain_point = membrane_run(LoadKind::point, Constants::card, 1.12),
            plain_disc = membrane_run(LoadKind::disc, Constants::card, 1.5);
  result.explanations = {*explain(result.runs[0], {&plain_point, &result.runs[2], &result.runs[6], &result.runs[7]},
                                  {{5, 20}, {1.001, 1.002}}),
                         *explain(result.runs[1], {&plain_disc, &result.runs[3], &result.runs[8], &result.runs[9]},
                                  {{5, 20}, {0.999, 0.998}})};
  add_biases(result);
  judge(result);
  compare_curves(result);
  result.timing = {.wall_s = 51,
                   .membrane_s = 2,
                   .atomistic_s = 48,
                   .force_s = 30,
                   .setup_s = 3,
                   .factor_s = 6,
                   .solve_s = 5,
                   .force_calls = 260};
  result.provenance = provenance();
  return result;
}

Result membrane_only() {
  Result result;
  result.resolved.models = Models::membrane;
  result.resolved.loads = {LoadKind::disc};
  result.resolved.E_eV_per_A3 = 6.37;
  result.resolved.thickness_A = 3.35;
  result.resolved.nu = 0.165;
  result.runs = {membrane_run(LoadKind::disc, Constants::given, 1.2)};
  judge(result);
  result.timing.wall_s = 1;
  result.timing.membrane_s = 0.9;
  result.provenance = provenance();
  result.provenance.lammps.clear();
  result.provenance.potential_file.clear();
  result.provenance.potential_sha256.clear();
  return result;
}

Result atoms_failed() {
  Result result;
  Run atoms;
  atoms.model = Model::atomistic;
  settle_part(atoms);
  atoms.load = LoadKind::disc;
  atoms.a_A = a_A;
  atoms.tip_A = 10.2;
  atoms.ended_reason = "ERROR: Lost atoms";  // `ended` stays empty
  fit_run(atoms);
  result.runs = {atoms, membrane_run(LoadKind::disc, Constants::paper, 1.35)};
  judge(result);
  result.timing.wall_s = 3;
  return result;
}

}  // namespace sample
