#include "compare/study/study.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <map>

#include "atomistic/protocol/step_file.hpp"
#include "compare/base/errors.hpp"
#include "compare/base/interrupt.hpp"
#include "compare/fitting/curve.hpp"
#include "compare/fitting/fit_warnings.hpp"
#include "compare/fitting/run_fit.hpp"
#include "compare/pairing/pairing.hpp"
#include "compare/potential/potential_card.hpp"
#include "compare/process/atoms_curves.hpp"
#include "compare/process/provenance.hpp"
#include "compare/study/continua.hpp"
#include "compare/study/curves.hpp"
#include "compare/verdict/agreement.hpp"

namespace validate {
namespace {

namespace fs = std::filesystem;

void add(Timing& timing, const atomistic::Report& report) {
  timing.force_calls = timing.force_calls.value_or(0) + report.force_calls;
  timing.force_s = timing.force_s.value_or(0) + report.force_s;
  timing.setup_s = timing.setup_s.value_or(0) + report.setup_s;
  timing.factor_s = timing.factor_s.value_or(0) + report.factor_s;
  timing.solve_s = timing.solve_s.value_or(0) + report.solve_s;
}

std::vector<double> levels_of(const Case& c) { return c.forces_eV_per_A.empty() ? depth_levels(c) : c.forces_eV_per_A; }

/// Without more levels the order stays: dead loads may be given in any.
std::vector<double> merged(std::vector<double> levels, const std::vector<double>& more) {
  if (more.empty()) return levels;
  levels.insert(levels.end(), more.begin(), more.end());
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end(), [](double a, double b) { return b - a < 1e-9 * b; }),
               levels.end());
  return levels;
}

/// step, 2 step, … and the deepest.
std::vector<double> grid_levels(double step, double deepest) {
  std::vector<double> levels;
  for (int k = 1; k * step < deepest * (1 - 1e-9); ++k) levels.push_back(k * step);
  levels.push_back(deepest);
  return levels;
}

/// For what makes the atoms' ratio of controlled depth and depth of record another one than a membrane's: bending, by
/// 0.2 % at 110 Å and 1.4 % at 30 Å.
double window_margin(double radius_A) { return 0.005 + 0.6 / radius_A; }

/// Controlled depths at which a curve's depth of record is just below lo and just above hi, as far as it reaches.
std::vector<double> window_ends(const Run& scout, double lo_A, double hi_A, double radius_A) {
  const double margin = window_margin(radius_A);
  std::vector<double> levels;
  if (scout.depth_A.size() < 2) return levels;
  const Curve controlled(scout.depth_A, scout.conjugate_depth_A);
  for (const double depth : {lo_A * (1 - margin), hi_A * (1 + margin)})
    if (const auto level = controlled.at(depth)) levels.push_back(*level);
  return levels;
}

class Study {
 public:
  Study(const Case& c, const std::optional<PotentialFile>& potential, const StudyOptions& options, Progress& progress)
      : case_(c), potential_(potential), options_(options), progress_(progress) {
    outcome_.result.resolved = c;
    outcome_.result.provenance = provenance(command_line());
  }

  StudyOutcome run() {
    const double start = seconds();
    if (potential_) {
      outcome_.result.provenance.potential_file = potential_->potential.file;
      outcome_.result.provenance.potential_sha256 = potential_->sha256;
      outcome_.result.provenance.potential_edit = potential_->edit;
      if (compute_card()) compare_models();
    } else {
      for (const std::string& load : case_.loads) continua_.add(given_membrane(case_, load, levels_of(case_)));
      compute_curves();
    }
    finish();
    outcome_.result.timing.wall_s = seconds() - start;
    return std::move(outcome_);
  }

 private:
  bool wants_membrane() const { return case_.models != "atomistic"; }
  bool wants_atoms() const { return potential_ && case_.models != "membrane"; }
  fs::path work() const { return options_.folder / "work"; }

  bool compute_card() {
    progress_.say(fmt::format("potential card of {}", case_.potential));
    try {
      PotentialCard found = potential_card(*potential_, options_.launch, card_cache(), false);
      card_ = found.card;
      law_ = std::move(found.law);
      outcome_.result.law_missing = found.no_law;
      outcome_.result.provenance.lammps = found.lammps;
    } catch (const Error& error) {
      if (error.exit_code() == ExitCode::bad_input)
        throw bad_input("potential '{}': {}", case_.potential, error.what());
      if (error.exit_code() != ExitCode::atomistic_failed) throw;
      outcome_.failure = std::string("the potential card: ") + error.what();
      return false;
    }
    outcome_.result.card = summary_of(*card_, potential_->potential.artefact_bond_A);
    if (law_) outcome_.result.law = summary_of(*law_, card_->bending_modulus_eV());
    progress_.say(fmt::format("card: a0 = {:.5f} Å, E·h = {:.3f} eV/Å², ν = {:.4f}, κ = {:.3f} eV", card_->a0_A,
                              card_->sheet_modulus_eV_per_A2(), card_->nu(), card_->bending_modulus_eV()));
    return true;
  }

  void note_start(const atomistic::Event& event) {
    if (const auto* e = std::get_if<atomistic::StartEvent>(&event))
      outcome_.result.provenance.lammps = lammps_release(e->lammps_version);
  }

  void compare_models() {
    pair_.emplace(case_, potential_->potential, *card_);
    for (const std::string& load : case_.loads) {
      const std::vector<double> levels = merged(levels_of(case_), window_levels(load));
      if (wants_atoms()) {
        atoms_.push_back(atomistic_experiment(case_, potential_->potential, *card_, *pair_, load, levels));
        if (guided()) atoms_.back().problem.guides = guides_from(calibrated(load, levels, Model::sheet).problem);
      }
      if (wants_membrane()) add_continua(load, levels);
    }
    if (wants_atoms()) {
      outcome_.sheet = pair_->sheet();
      outcome_.result.sheet = SheetSummary{
          .radius_A = case_.radius_A,
          .effective_radius_A = pair_->effective_radius_A(),
          .atoms = pair_->sheet().atoms(),
          .free_atoms = pair_->sheet().free_atoms,
          .loaded_disc_atoms = static_cast<int>(atomistic::atoms_within(pair_->sheet(), case_.tip_radius_A).size())};
    }
    compute_curves();
  }

  void add_continua(const std::string& load, const std::vector<double>& levels) {
    const bool depths = case_.forces_eV_per_A.empty();
    continua_.add(card_membrane(case_, *card_, *pair_, load, depths ? enclosing(levels) : levels));
    continua_.add(paper_membrane(case_, load, levels_of(case_)));
    if (!law_) return;
    const std::vector<double> finer = depths ? with_halves(enclosing(levels)) : levels;
    continua_.add_calibrated(plain_experiments(case_, *card_, *pair_, load, finer),
                             calibrated(load, finer, Model::membrane), calibrated(load, finer, Model::sheet), *law_);
  }

  /// Rings do not describe a sheet with defects.
  bool guided() const { return law_ && case_.vacancies_A.empty() && case_.stone_wales_A.empty(); }

  SheetExperiment calibrated(const std::string& load, const std::vector<double>& levels, Model model) const {
    return calibrated_experiment(case_, *card_, *law_, *pair_, load, levels, model,
                                 potential_->potential.artefact_bond_A);
  }

  /// More controlled depths for the judged load, by the continuum that it is judged against: just below the window's
  /// lower end, just above its upper one, and those in between that the case's own list leaves out.
  std::vector<double> window_levels(const std::string& load) const {
    if (load != case_.judged_load || case_.models != "both" || !case_.forces_eV_per_A.empty()) return {};
    if (case_.against == "sheet") return law_ ? sheet_window_levels(load) : std::vector<double>();
    const double a = pair_->effective_radius_A(), shallow = 0.5 * case_.window.front() * a;
    MembraneExperiment scout = card_membrane(case_, *card_, *pair_, load, merged(levels_of(case_), {shallow}));
    solve(scout);
    return window_ends(scout.run, case_.window.front() * a, case_.window.back() * a, case_.radius_A);
  }

  std::vector<double> sheet_window_levels(const std::string& load) const {
    const double step = depth_step_A(case_), a = pair_->effective_radius_A();
    const double deepest = case_.depth_max_A.value_or(case_.window.back() * a),
                 shallow = 0.5 * case_.window.front() * a;
    // Finer than the atoms' steps: near its end a sheet tears within a step.
    constexpr double parts = 4, margin_A = 0.015;  // the latter of the predicted bond, on the smallest sheets
    SheetExperiment scout = calibrated(load, merged(grid_levels(step / parts, deepest), {shallow}), Model::sheet);
    solve(scout);
    if (scout.run.depth_A.size() < 2) return {};
    const double torn = scout.run.depth_A.back() / (1 + 2 * window_margin(case_.radius_A));
    const double end = std::min(
        {case_.window.back() * a, torn, depth_at_bond(scout.run, case_.window_bond_A + margin_A).value_or(torn)});
    std::vector<double> levels = window_ends(scout.run, case_.window.front() * a, end, case_.radius_A);
    if (case_.depth_max_A) return levels;
    const double last = levels.empty() ? 0 : levels.back();
    for (const double level : grid_levels(step, last))
      if (level > largest_depth_A(case_)) levels.push_back(level);
    return levels;
  }

  void compute_curves() {
    continua_.start(options_.all_fields);
    if (!atoms_.empty()) compute_atoms();
    outcome_.result.timing.membrane_s = continua_.join();
    if (interrupted()) throw Error(ExitCode::interrupted, "interrupted");
  }

  fs::path steps_folder(const AtomisticExperiment& e) const { return work() / e.run.load / "steps"; }

  int ranks_per_curve() const {
    if (options_.ranks > 0) return options_.ranks;
    return useful_ranks(options_.launch, pair_->sheet().atoms(), static_cast<int>(atoms_.size()));
  }

  void compute_atoms() {
    const double start = seconds();
    std::vector<AtomsJob> jobs;
    for (const AtomisticExperiment& e : atoms_) {
      fs::create_directories(steps_folder(e));
      jobs.push_back(
          {e.run.load,
           {atomistic::CurveJob{e.problem, steps_folder(e).string()}, (work() / e.run.load / "log.lammps").string()},
           ranks_per_curve()});
    }
    progress_.say(
        fmt::format("{} atoms, {} curve(s), {} rank(s) each", pair_->sheet().atoms(), jobs.size(), jobs.front().ranks));
    std::vector<std::optional<atomistic::Report>> reports(jobs.size());
    const auto outcomes =
        run_jobs(options_.launch, jobs, work(), [&](std::size_t index, const atomistic::Event& event) {
          note_start(event);
          if (const auto* e = std::get_if<atomistic::ProgressEvent>(&event)) show(index, *e);
          if (const auto* e = std::get_if<atomistic::StepEvent>(&event)) tell(index, *e);
          if (const auto* e = std::get_if<atomistic::EndEvent>(&event)) reports[index] = e->report;
        });
    for (std::size_t i = 0; i < atoms_.size(); ++i) collect(atoms_[i], reports[i], outcomes[i]);
    outcome_.result.timing.atomistic_s = seconds() - start;
  }

  /// The run of a curve is rebuilt from its step files: what a kill or an error leaves is never more than
  /// they hold.
  void collect(AtomisticExperiment& e, const std::optional<atomistic::Report>& report, const AtomsOutcome& outcome) {
    const std::vector<atomistic::Step> steps = atomistic::read_finished_steps(steps_folder(e));
    for (const atomistic::Step& step : steps)
      if (!step.unloading) append(e.run, step, potential_->potential.artefact_bond_A);
    if (case_.unloading) outcome_.result.unloading.push_back(unloading_of(e.run, steps));
    if (outcome.finished && report) {
      close(e.run, *report);
      add(outcome_.result.timing, *report);
    } else {
      e.run.ended.reset();
      e.run.ended_reason = outcome.failure;
      if (outcome.fault == atomistic::Fault::file) outcome_.failure_code = ExitCode::file_failed;
      if (outcome_.failure.empty()) outcome_.failure = fmt::format("atoms, {} load: {}", e.run.load, outcome.failure);
    }
  }

  /// Levels done so far, a level in progress counting half.
  void show(std::size_t index, const atomistic::ProgressEvent& event) {
    const auto& levels = atoms_[index].problem.levels;
    const double steps = static_cast<double>(levels.size()) * (case_.unloading ? 2 : 1) - (case_.unloading ? 1 : 0);
    done_[atoms_[index].run.load] = (event.level + 0.5) / steps;
    double sum = 0;
    for (const auto& [load, done] : done_) sum += done;
    const double fraction = sum / static_cast<double>(atoms_.size());
    const double left = progress_.elapsed_s() * (1 - fraction) / std::max(fraction, 1e-3);
    progress_.status(fmt::format("{} about {:.0f} s left; {}: level {}/{}, {} evaluations, max|f| {:.1e} eV/Å",
                                 bar(fraction), left, atoms_[index].run.load, event.level + 1, levels.size(),
                                 event.evaluations, event.max_force_eV_per_A));
  }

  void tell(std::size_t index, const atomistic::StepEvent& event) {
    const AtomisticExperiment& e = atoms_[index];
    const atomistic::Step step = atomistic::read_step(steps_folder(e) / event.file);
    progress_.say(fmt::format(
        "atoms {:5} {:2}/{}  depth {:7.3f} Å  force {:10.5f} eV/Å  {:3} evaluations  longest bond {:.3f} Å{}",
        e.run.load, event.level + 1, e.problem.levels.size(), step.depth_A, step.force_eV_per_A, step.evaluations,
        step.longest_bond_A,
        step.longest_bond_A >= e.problem.potential.artefact_bond_A - 0.02 ? "  (near the artefact zone)" : ""));
  }

  void finish() {
    Result& result = outcome_.result;
    for (AtomisticExperiment& e : atoms_) result.runs.push_back(std::move(e.run));
    continua_.collect(result);
    for (Run& run : result.runs) fit_run(run);
    add_biases(result);
    add_direct_fits(result);
    add_warnings(result);
    judge(result);
    compare_curves(result);
  }

  const Case& case_;
  const std::optional<PotentialFile>& potential_;
  const StudyOptions& options_;
  Progress& progress_;
  std::optional<atomistic::Card> card_;
  std::optional<CalibratedLaw> law_;
  std::optional<PairedSheet> pair_;
  std::vector<AtomisticExperiment> atoms_;
  Continua continua_;
  std::map<std::string, double> done_;
  StudyOutcome outcome_;
};

}  // namespace

StudyOutcome run_study(const Case& c, const std::optional<PotentialFile>& potential, const StudyOptions& options,
                       Progress& progress) {
  return Study(c, potential, options, progress).run();
}

}  // namespace validate
