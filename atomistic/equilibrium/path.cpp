#include "atomistic/equilibrium/path.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "atomistic/equilibrium/guide.hpp"
#include "atomistic/equilibrium/newton_krylov.hpp"
#include "atomistic/lattice/ripple.hpp"
#include "atomistic/loads/rim_pull.hpp"
#include "atomistic/loads/sphere_load.hpp"
#include "atomistic/protocol/preconditioning.hpp"

namespace atomistic {

using Eigen::VectorXd;

namespace {

/// The sheet stiffens with its tension, ∝ depth²: a factor serves until the depth has changed by this ratio …
constexpr double depth_ratio_per_factor = 1.3;

/// … or until a level needs this many evaluations more than the first one that the factor served.
constexpr int tolerated_extra_evaluations = 0;

/// A level that needs more evaluations than this gets a fresh factor at its current positions.
constexpr int evaluations_per_factor = 40;

/// A level that needs more evaluations than this is solved by Newton's method, with fresh factors less often.
constexpr int evaluations_before_newton = 160;
constexpr int evaluations_per_newton_factor = 200;

/// A search's minimisation that has lost a bond after so many evaluations, more than what is borne takes, has broken.
constexpr int evaluations_before_lost = 20;

constexpr const char* every_level = "every level reached";
constexpr const char* into_the_switch = "the longest bond has reached the potential's cut-off switch";

/// How much stiffer the contact is made to see what its softness does.
constexpr double stiffer_contact = 4;

bool controls_depth(const Problem& problem) {
  return problem.control == Control::conjugate_depth && !std::holds_alternative<PressureLoad>(problem.load);
}

Preconditioning kind_for(const Problem& problem, const Sheet& sheet) {
  return preconditioning_for(problem.preconditioning, sheet.free_atoms);
}

}  // namespace

Path::Path(const Problem& problem, const Sheet& sheet, ForceField& forces, const PathCallbacks& callbacks)
    : Path(problem, sheet, nullptr, Preconditioner(kind_for(problem, sheet), sheet, spring_constants(problem.card)),
           forces, callbacks) {}

Path::Path(const Problem& problem, const SharedSheet& sheet, ForceField& forces, const PathCallbacks& callbacks)
    : Path(problem, sheet.part(), &sheet,
           Preconditioner(sheet.part(), sheet.solver(spring_constants(problem.card)), sheet.team()), forces,
           callbacks) {}

Path::Path(const Problem& problem, const Sheet& sheet, const SharedSheet* shared, Preconditioner preconditioner,
           ForceField& forces, const PathCallbacks& callbacks)
    : problem_(problem),
      sheet_(sheet),
      shared_(shared),
      force_field_(forces),
      callbacks_(callbacks),
      load_(make_load(problem, sheet, team())),
      rim_pull_(rim_pull(sheet, problem.rim_tension_eV_per_A2)),
      preconditioner_(std::move(preconditioner)),
      reference_(sheet.positions),
      positions_(sheet.positions),
      break_(problem.potential.artefact_bond_A, controls_depth(problem)) {
  if (!sheet.built_in_equilibrium()) relax_flat_sheet();
  VectorXd unused = VectorXd::Zero(free_dofs());
  flat_energy_ = evaluate(reference_, true) + pull(reference_.head(free_dofs()), unused);
}

double Path::evaluate(const VectorXd& positions, bool fresh) {
  if (!shared_) return force_field_.evaluate(positions, atom_forces_, fresh);
  return force_field_.evaluate_own(positions.head(free_dofs()), atom_forces_, fresh);
}

/// What others have moved, where this rank looks at their atoms.
void Path::refresh() {
  if (shared_) shared_->refresh(positions_);
}

void Path::tell(const Step& step) const {
  if (!shared_) return callbacks_.on_step(step);
  const Step whole = shared_->whole_step(step);
  if (callbacks_.on_step) callbacks_.on_step(whole);
}

double Path::mean_record_depth(const VectorXd& x) const {
  double sum = 0;
  for (int atom : sheet_.record) sum -= x[3 * atom + 2];
  return team().sum(sum) / team().sum(static_cast<double>(sheet_.record.size()));
}

double Path::longest() const { return team().largest(longest_bond(sheet_, positions_)); }

Report Path::follow(const std::vector<Step>& finished) {
  take_over(finished);
  report_.reason = every_level;
  for (const Step& step : finished) end_reached(step);
  int number = static_cast<int>(finished.size());
  while (const auto target = next_target()) {
    const Step step = run_level(number++, *target);
    remember(step);
    end_reached(step);
    tell(step);
  }
  report_.contact = check_contact();
  report_.force_calls = force_field_.timing().calls;
  report_.force_s = force_field_.timing().force_s;
  report_.setup_s += force_field_.timing().setup_s;
  report_.preconditioning = shared_ ? Preconditioning::multigrid : kind_for(problem_, sheet_);
  report_.factor_s = preconditioner_.factor_s();
  report_.solve_s = preconditioner_.solve_s();
  return report_;
}

/// The equilibrium in the plane around defects and along sliding edges. z stays 0, where it is in balance by
/// symmetry.
void Path::relax_flat_sheet() {
  preconditioner_.factorise(positions_, nullptr);
  const auto flat = [](VectorXd v) {
    for (Eigen::Index z = 2; z < v.size(); z += 3) v[z] = 0;
    return v;
  };
  const Minimisation problem{.evaluate =
                                 [&](const VectorXd& x) {
                                   positions_.head(free_dofs()) = x;
                                   const double energy = evaluate(positions_, std::exchange(fresh_, false));
                                   Evaluation e{energy, -atom_forces_.head(free_dofs())};
                                   e.energy += pull(x, e.gradient);
                                   e.gradient = flat(e.gradient);
                                   return e;
                                 },
                             .precondition = [&](const VectorXd& r) { return flat(preconditioner_.solve(r)); },
                             .constraint = {},
                             .constraint_response = {}};
  VectorXd x = free_positions();
  const MinimiserReport result = minimise(
      problem, {.force_tolerance = tolerance() / 10, .longest_step = 0.1, .max_evaluations = problem_.max_evaluations},
      x);
  report_.relaxation_evaluations = result.evaluations;
  if (!result.converged) {
    report_.ended = Ended::not_converged;
    report_.reason = "the flat sheet did not relax: " + result.reason;
  }
  positions_.head(free_dofs()) = x;
  reference_ = positions_;
}

std::optional<Path::Target> Path::next_target() {
  const bool goes_on = report_.ended == Ended::depth_max;
  if (report_.ended == Ended::rupture) {
    const auto between = break_.next_level();
    return between ? std::optional(Target{.level = *between, .search = true}) : std::nullopt;
  }
  if (!unloading_from_) {
    if (goes_on && loaded_levels_ < static_cast<int>(problem_.levels.size()))
      return Target{.level = problem_.levels[loaded_levels_]};
    if (!problem_.unload || loaded_levels_ < 2 || !(goes_on || report_.ended == Ended::artefact)) return std::nullopt;
    unloading_from_ = loaded_levels_ - 1;
  }
  if (*unloading_from_ == 0 || report_.ended == Ended::not_converged) return std::nullopt;
  return Target{.level = problem_.levels[*unloading_from_ - 1], .unloading = true};
}

/// The state that an earlier run had after its last finished step.
void Path::take_over(const std::vector<Step>& finished) {
  double factorised_level = 0;
  for (const Step& step : finished) {
    remember(shared_ ? shared_->part_of_step(step) : step);
    if (step.factorisations > 0) factorised_level = step.target;
  }
  if (finished.empty()) return;
  load_->set_level(factorised_level);
  factorise(shared_ ? shared_->part_of_step(finished.back()).factorised_at : finished.back().factorised_at);
  preconditioner_.constraint_response(
      load_->constraint());  // as the level that made the factor did: its solve, not ours
}

/// What the next levels use: the state, and how well the factor has served.
void Path::remember(const Step& step) {
  const double t = load_->parameter(step.target);
  const bool kept = step.converged && !step.broken;
  if (!step.unloading) break_.take(step);
  if (kept && step.positions.size() > 0) {
    std::erase_if(states_, [&](const PathState& s) { return std::abs(s.t - t) < 1e-9 * t; });  // the path came back
    states_.push_back({t, (step.positions - reference_).head(free_dofs()), guide(step.target)});
  }
  if (kept) curve_.emplace_back(step.depth_A, step.force_eV_per_A);
  if (states_.size() > 3) states_.erase(states_.begin());
  if (step.factorisations > 0) {
    first_evaluations_ = step.evaluations;
    factor_parameter_ = t;
  }
  factor_is_tired_ =
      step.broken || step.factorisations > 1 || step.evaluations > first_evaluations_ + tolerated_extra_evaluations;
  if (step.search) return;
  if (step.unloading)
    unloading_from_ = unloading_from_.value_or(loaded_levels_ - 1) - 1;
  else
    ++loaded_levels_;
}

void Path::factorise(const VectorXd& positions) {
  preconditioner_.factorise(positions, load_.get());
  factorised_at_ = positions;
  ++factorisations_;
}

void Path::predict(int number, double level) {
  load_->set_level(level);
  const double t = load_->parameter(level);
  VectorXd x = reference_.head(free_dofs());
  const auto expected = guide(level);
  x += states_.empty() && !expected ? load_->first_guess() : extrapolate(states_, t, expected);
  if (problem_.ripple_A > 0 && problem_.ripple_waves > 0)
    x += ripple_around(sheet_, problem_.ripple_A, problem_.ripple_waves);
  else if (problem_.ripple_A > 0)
    x += ripple(sheet_, problem_.ripple_A, problem_.ripple_seed + static_cast<unsigned>(number));
  hold_what_slides(x);
  load_->admit(x);
  positions_.head(free_dofs()) = x;
  const double ratio = t / factor_parameter_;
  refresh();
  if (factor_is_tired_ || ratio > depth_ratio_per_factor || ratio * depth_ratio_per_factor < 1) factorise(positions_);
  meet_constraint(level);
}

std::optional<VectorXd> Path::guide(double level) const { return guided_displacement(problem_, sheet_, level); }

/// Moves the prediction onto the constraint along P⁻¹c, the network's own response to the load.
void Path::meet_constraint(double level) {
  const VectorXd c = load_->constraint();
  if (c.size() == 0) return;
  const VectorXd& response = preconditioner_.constraint_response(c);
  const double missing = level - load_->conjugate_depth(free_positions());
  positions_.head(free_dofs()) -= response * (missing / dot(c, response));
}

/// Sliding atoms keep their z: no displacement, no gradient.
void Path::hold_what_slides(VectorXd& v) const {
  for (std::size_t i = 0; i < sheet_.slides.size(); ++i)
    if (sheet_.slides[i]) v[3 * static_cast<Eigen::Index>(i) + 2] = 0;
}

/// Potential of the rim's dead forces (eV), their gradient added.
double Path::pull(const VectorXd& x, VectorXd& gradient) const {
  gradient -= rim_pull_;
  return -rim_pull_.dot(x - sheet_.positions.head(free_dofs()));
}

Minimisation Path::minimisation() {
  return {.evaluate =
              [this](const VectorXd& x) {
                positions_.head(free_dofs()) = x;
                Evaluation e;
                e.energy = evaluate(positions_, std::exchange(fresh_, false));
                e.gradient = -atom_forces_.head(free_dofs());
                e.energy += pull(x, e.gradient) + load_->add(x, e.gradient);
                hold_what_slides(e.gradient);
                return e;
              },
          .precondition = [this](const VectorXd& r) { return preconditioner_.solve(r); },
          .constraint = load_->constraint(),
          .constraint_response = {},
          .team = &team()};
}

bool Path::torn() const {
  const double lowest = team().least(positions_.reshaped(3, sheet_.atoms()).row(2).minCoeff());
  return longest() > torn_bond_A || lowest < -torn_depth_of_radius * sheet_.radius_A;
}

/// A bond that is lost on the way does not come back where a search starts, close to its end, nor where a level drags
/// on.
bool Path::has_broken(const Target& target, int evaluations) const {
  const bool hopeless = evaluations >= (target.search ? evaluations_before_lost : evaluations_before_newton);
  return hopeless && !target.unloading && break_.lost(target.level, longest());
}

/// Minimises; a level that drags on gets fresh factors at its current positions.
MinimiserReport Path::minimise_level(int number, const Target& target) {
  Minimisation problem = minimisation();
  MinimiserOptions options{.force_tolerance = tolerance()};
  MinimiserReport result;
  int evaluations = 0;
  for (;;) {
    problem.constraint_response = preconditioner_.constraint_response(problem.constraint);
    options.max_evaluations = std::min(evaluations_per_factor, problem_.max_evaluations - evaluations);
    VectorXd x = free_positions();
    const auto on_iteration = [&](int done, double max_force) {
      refresh();
      if (callbacks_.on_progress) callbacks_.on_progress({number, evaluations + done, max_force});
      return !torn() && !has_broken(target, evaluations + done);
    };
    const bool drags_on = evaluations >= evaluations_before_newton;
    if (drags_on)
      options.max_evaluations = std::min(evaluations_per_newton_factor, problem_.max_evaluations - evaluations);
    result = (drags_on ? minimise_by_newton : minimise)(problem, options, x, on_iteration);
    evaluations += result.evaluations;
    options.trust_radius = result.trust_radius;
    positions_.head(free_dofs()) = x;
    refresh();
    if (result.converged || evaluations >= problem_.max_evaluations || torn() || has_broken(target, evaluations)) break;
    factorise(positions_);
  }
  result.evaluations = evaluations;
  return result;
}

Step Path::run_level(int number, const Target& target) {
  factorisations_ = 0;
  const int solves_before = preconditioner_.solves();
  fresh_ = true;
  predict(number, target.level);
  const MinimiserReport result = minimise_level(number, target);

  const VectorXd x = free_positions();
  Step step;
  step.level = number;
  step.unloading = target.unloading;
  step.search = target.search;
  step.target = target.level;
  step.converged = result.converged;
  step.positions = positions_;
  step.forces = atom_forces_;
  step.factorised_at = factorised_at_;
  if (problem_.virials) step.virials = force_field_.virials(positions_);
  step.conjugate_depth_A = load_->conjugate_depth(x);
  step.depth_A = mean_record_depth(x);
  step.force_eV_per_A = load_->force(x, result.multiplier);
  step.energy_eV = result.last.energy - load_->dead_work(x) - flat_energy_;
  step.max_force_eV_per_A = result.max_force;
  step.balance_relative = balance(result.multiplier);
  step.force_error_relative = std::abs(result.energy_residual / (step.force_eV_per_A * step.conjugate_depth_A));
  step.longest_bond_A = longest();
  step.broken = !step.unloading && break_.broken(step);
  step.evaluations = result.evaluations;
  step.factorisations = factorisations_;
  step.solves = preconditioner_.solves() - solves_before;
  if (!result.converged && !step.search) report_.reason = result.reason;
  return step;
}

/// All forces among the atoms cancel, so what holds the sheet's edge carries minus the sum over all others;
/// it must be what the load puts on them.
double Path::balance(double multiplier) {
  VectorXd load = VectorXd::Zero(free_dofs());
  load_->add(free_positions(), load);
  if (const VectorXd c = load_->constraint(); c.size()) load -= multiplier * c;
  double carried = 0, put_on = 0;
  for (int i = 0; i < sheet_.free_atoms; ++i) {
    if (!sheet_.slides.empty() && sheet_.slides[i]) continue;
    carried += atom_forces_[3 * i + 2];
    put_on += load[3 * i + 2];
  }
  put_on = team().sum(put_on);
  return std::abs((team().sum(carried) - put_on) / put_on);
}

/// Rupture and artefact come first: a minimisation that fails among them is no failure of the path.
void Path::end_reached(const Step& step) {
  if (step.search) {
    if (!break_.refuted() || report_.ended != Ended::rupture) return;
    report_.ended = problem_.past_artefact ? Ended::depth_max : Ended::artefact;
    report_.reason = problem_.past_artefact ? every_level : into_the_switch;
  } else if (step.broken || step.longest_bond_A >= ruptured_bond_A) {
    report_.ended = Ended::rupture;
    report_.reason = "a bond of the sheet has broken";
  } else if (step.longest_bond_A >= problem_.potential.artefact_bond_A &&
             !(step.converged && (problem_.past_artefact || step.unloading))) {
    report_.ended = Ended::artefact;
    report_.reason = into_the_switch;
  } else if (!step.converged) {
    report_.ended = Ended::not_converged;
  }
}

/// Solves the last depth of a sphere again with a stiffer contact.
std::optional<ContactCheck> Path::check_contact() {
  auto* sphere = dynamic_cast<SphereTerm*>(load_.get());
  if (!sphere || states_.empty() || report_.ended == Ended::not_converged) return std::nullopt;
  const VectorXd before = reference_.head(free_dofs()) + states_.back().displacement;
  const double stiffness = std::get<SphereLoad>(problem_.load).stiffness_eV_per_A3;
  ContactCheck check;
  check.deepest_penetration_A = sphere->deepest_penetration(before);
  const double force = sphere->force(before, 0);
  sphere->set_stiffness(stiffer_contact * stiffness);
  VectorXd x = before;
  sphere->admit(x);
  positions_.head(free_dofs()) = x;
  refresh();
  factorise(positions_);
  fresh_ = true;
  const MinimiserReport result = minimise_level(static_cast<int>(problem_.levels.size()), {});
  if (!result.converged) return std::nullopt;
  check.force_change_relative = sphere->force(free_positions(), 0) / force - 1;
  check.depth_change_A = mean_record_depth(free_positions()) - mean_record_depth(before);
  const auto [depth, ignored] = curve_.back();
  const auto [earlier_depth, earlier_force] =
      curve_.size() > 1 ? curve_[curve_.size() - 2] : std::pair(depth / 2, force / 8);
  const double exponent = std::log(force / earlier_force) / std::log(depth / earlier_depth);
  check.force_change_at_equal_depth_relative = check.force_change_relative - exponent * check.depth_change_A / depth;
  return check;
}

}  // namespace atomistic
