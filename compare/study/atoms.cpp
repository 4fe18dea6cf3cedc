#include "compare/study/atoms.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "atomistic/loads/rim_pull.hpp"
#include "compare/process/atoms_curves.hpp"
#include "compare/study/breaking.hpp"
#include "compare/study/cross_section.hpp"
#include "compare/study/curves.hpp"
#include "compare/study/heating.hpp"

namespace validate {
namespace {

void add(Timing& timing, const atomistic::Report& report) {
  timing.force_calls = timing.force_calls.value_or(0) + report.force_calls;
  timing.force_s = timing.force_s.value_or(0) + report.force_s;
  timing.setup_s = timing.setup_s.value_or(0) + report.setup_s;
  timing.factor_s = timing.factor_s.value_or(0) + report.factor_s;
  timing.solve_s = timing.solve_s.value_or(0) + report.solve_s;
}

/// With the wrinkles of a sheet whose rim is pulled.
void add_step(Run& run, const atomistic::Step& step, const atomistic::Sheet& sheet, double artefact_bond_A,
              bool broken) {
  append(run, step, artefact_bond_A, broken);
  if (!std::isfinite(run.rim_tension_eV_per_A2)) return;
  run.rim_displacement_A.push_back(atomistic::rim_displacement_A(sheet, step.positions));
  append(run, wrinkles_of(points_of(sheet, step.positions), run.a_A));
}

/// The run of a curve is rebuilt from its step files: what a kill or an error leaves is never more than they hold.
void collect(AtomisticExperiment& e, const AtomsCurve& curve, const atomistic::Sheet& sheet, StudyOutcome& outcome) {
  const double artefact_bond_A = e.problem.potential.artefact_bond_A;
  // What broke may have turned out to be a long step into the switch.
  const bool refuted = curve.report && curve.report->ended != atomistic::Ended::rupture;
  for (const atomistic::Step* step : steps_of_curve(curve.steps))
    add_step(e.run, *step, sheet, artefact_bond_A, step->broken && !refuted);
  if (!refuted) e.run.atoms().breaking = breaking_of(curve.steps, artefact_bond_A);
  if (e.problem.unload) outcome.result.unloading.push_back(unloading_of(e.run, curve.steps));
  if (e.run.load == LoadKind::pressure && !curve.steps.empty())
    e.run.cross_section = cross_section(sheet, curve.steps.back().positions);
  if (!curve.lammps.empty()) outcome.result.provenance.lammps = curve.lammps;
  if (curve.failure.empty() && curve.report) {
    close(e.run, *curve.report);
    add(outcome.result.timing, *curve.report);
    return;
  }
  e.run.ended.reset();
  e.run.ended_reason = curve.failure;
  if (!outcome.failure.empty()) return;
  outcome.failure_code = curve.failure_code;
  outcome.failure = curve.failure;
}

}  // namespace

void compute_atoms(std::vector<PairedLoad>& loads, const atomistic::Sheet& sheet, const StudyOptions& options,
                   StudyOutcome& outcome, Progress& progress) {
  const double start = seconds();
  std::vector<AtomsPath> paths;
  for (const PairedLoad& load : loads)
    paths.push_back({.name = std::string(to_string(load.load)),
                     .problem = load.atoms->problem,
                     .keep_positions = has_pulled_rim(outcome.result.resolved)});
  AtomsLaunch launch = options.launch;
  const int ranks =
      options.ranks > 0 ? options.ranks : useful_ranks(options.launch, sheet.atoms(), static_cast<int>(paths.size()));
  progress.say(fmt::format("{} atoms, {} curve(s), {} rank(s) each", sheet.atoms(), paths.size(), ranks));
  if (options.curves_at_once > 0) launch.cores = std::min(launch.cores, options.curves_at_once * ranks);
  const std::vector<AtomsCurve> curves = compute_curves(launch, paths, ranks, options.folder / "work", progress);
  for (std::size_t i = 0; i < loads.size(); ++i) collect(*loads[i].atoms, curves[i], sheet, outcome);
  heat_atoms(loads, paths, curves, ranks, options, outcome, progress);
  outcome.result.timing.atomistic_s = seconds() - start;
}

}  // namespace validate
