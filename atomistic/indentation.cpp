#include "atomistic/indentation.hpp"

#include <chrono>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

#include "atomistic/loads/pattern.hpp"
#include "atomistic/minimiser.hpp"
#include "atomistic/predictor.hpp"
#include "atomistic/spring_network.hpp"

namespace atomistic {
namespace {

using Eigen::VectorXd;

/// Beyond this length no bundled carbon potential binds any more: AIREBO and REBO end at 2.0 Å.
constexpr double ruptured_bond_A = 2.0;

/// A search that has pulled two neighbours this far apart, or an atom this many radii down, will not bring them back: no
/// first guess starts there, and what follows is the flight of fragments out of the box.
constexpr double torn_bond_A = 5.0, torn_depth_of_radius = 2.0;

/// The sheet stiffens with its tension, ∝ depth²: a factor serves until the depth has grown by this ratio …
constexpr double depth_ratio_per_factor = 1.3;

/// … or until a level needs this many evaluations more than the first one that the factor served.
constexpr int tolerated_extra_evaluations = 0;

/// A level that needs more evaluations than this gets a fresh factor at its current positions.
constexpr int evaluations_per_factor = 40;

template <class Call>
auto timed(double& total_s, Call&& call) {
  const auto start = std::chrono::steady_clock::now();
  const auto stop = [&] {
    total_s += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  if constexpr (std::is_void_v<decltype(call())>) {
    call();
    stop();
  } else {
    auto result = call();
    stop();
    return result;
  }
}

Box box_around(const Sheet& sheet) {
  const double margin = 5, across = sheet.positions.cwiseAbs().maxCoeff() + margin;
  return {.low = {-across, -across, -torn_depth_of_radius * sheet.radius_A - margin},
          .high = {across, across, sheet.radius_A + margin}};
}

class Path {
 public:
  Path(const Problem& problem, const Sheet& sheet, ForceField& forces, const PathCallbacks& callbacks)
      : problem_(problem),
        sheet_(sheet),
        force_field_(forces),
        callbacks_(callbacks),
        pattern_(problem.load, sheet),
        network_(sheet, spring_constants(problem.card)),
        positions_(sheet.positions) {
    flat_energy_ = force_field_.evaluate(sheet.positions, atom_forces_, true);
  }

  Report follow(const std::vector<Step>& finished) {
    take_over(finished);
    report_.reason = "every level reached";
    for (int level = static_cast<int>(finished.size()); level < static_cast<int>(problem_.levels.size());
         ++level) {
      if (report_.ended != Ended::depth_max) break;
      Step step = run_level(level);
      remember(step);
      end_reached(step);
      callbacks_.on_step(step);
    }
    report_.force_calls = force_field_.timing().calls;
    report_.force_s = force_field_.timing().force_s;
    report_.setup_s += force_field_.timing().setup_s;
    return report_;
  }

 private:
  int free_dofs() const { return 3 * sheet_.free_atoms; }
  bool force_control() const { return problem_.control == Control::force; }

  /// The path parameter; grows like the depth in both kinds of control.
  double parameter(int level) const {
    return force_control() ? std::cbrt(problem_.levels[level]) : problem_.levels[level];
  }

  /// The state that an earlier run had after its last finished level.
  void take_over(const std::vector<Step>& finished) {
    if (finished.empty()) return;
    for (const Step& step : finished) remember(step);
    factorise(finished.back().factorised_at);
    end_reached(finished.back());
  }

  /// What the next levels use: the state, and how well the factor has served.
  void remember(const Step& step) {
    if (step.converged)
      states_.push_back({parameter(step.level), (step.positions - sheet_.positions).head(free_dofs())});
    if (states_.size() > 3) states_.erase(states_.begin());
    if (step.factorisations > 0) {
      first_evaluations_ = step.evaluations;
      factor_parameter_ = parameter(step.level);
    }
    factor_is_tired_ =
        step.factorisations > 1 || step.evaluations > first_evaluations_ + tolerated_extra_evaluations;
  }

  void factorise(const VectorXd& positions) {
    timed(report_.factor_s, [&] { network_.factorise(positions); });
    factorised_at_ = positions;
    ++factorisations_;
  }

  /// A depth that this force would cause, from the clamped membrane F = E·h (δ/a)³ a (Eq. 16 with q = 1).
  double depth_of_force(double force) const {
    const double a = sheet_.radius_A;
    return std::cbrt(force * a * a / problem_.card.sheet_modulus_eV_per_A2());
  }

  void predict(int level) {
    const double start = force_control() ? std::min(depth_of_force(problem_.levels[level]), sheet_.radius_A)
                                         : problem_.levels[level];
    const VectorXd u = states_.empty() ? first_guess(sheet_, start) : extrapolate(states_, parameter(level));
    positions_.head(free_dofs()) = sheet_.positions.head(free_dofs()) + u;
    if (factor_is_tired_ || parameter(level) > depth_ratio_per_factor * factor_parameter_)
      factorise(positions_);
    if (!force_control()) meet_depth(problem_.levels[level]);
  }

  /// Moves the prediction onto the constraint along P⁻¹c, the network's own response to the load.
  void meet_depth(double depth) {
    const VectorXd response = timed(report_.solve_s, [&] { return network_.solve(pattern_.direction()); });
    const double missing = depth - pattern_.conjugate_depth(positions_.head(free_dofs()));
    positions_.head(free_dofs()) -= response * (missing / pattern_.direction().dot(response));
  }

  Minimisation minimisation(int level) {
    const double dead_force = force_control() ? problem_.levels[level] : 0.0;
    return {
        .evaluate =
            [this, dead_force](const VectorXd& x) {
              positions_.head(free_dofs()) = x;
              Evaluation e;
              e.energy = force_field_.evaluate(positions_, atom_forces_, std::exchange(fresh_, false));
              e.gradient = -atom_forces_.head(free_dofs());
              if (dead_force > 0) {
                e.energy += dead_force * pattern_.direction().dot(x);
                e.gradient += dead_force * pattern_.direction();
              }
              return e;
            },
        .precondition =
            [this](const VectorXd& r) { return timed(report_.solve_s, [&] { return network_.solve(r); }); },
        .constraint = force_control() ? VectorXd() : pattern_.direction()};
  }

  bool torn() const {
    const double lowest = positions_.reshaped(3, sheet_.atoms()).row(2).minCoeff();
    return longest_bond(sheet_, positions_) > torn_bond_A || lowest < -torn_depth_of_radius * sheet_.radius_A;
  }

  /// Minimises; a level that drags on gets fresh factors at its current positions.
  MinimiserReport minimise_level(int level) {
    const Minimisation problem = minimisation(level);
    MinimiserOptions options{.force_tolerance = problem_.force_tolerance_eV_per_A};
    MinimiserReport result;
    int evaluations = 0;
    for (;;) {
      options.max_evaluations = std::min(evaluations_per_factor, problem_.max_evaluations - evaluations);
      VectorXd x = positions_.head(free_dofs());
      result = minimise(problem, options, x, [&](int done, double max_force) {
        if (callbacks_.on_progress) callbacks_.on_progress({level, evaluations + done, max_force});
        return !torn();
      });
      evaluations += result.evaluations;
      positions_.head(free_dofs()) = x;
      if (result.converged || evaluations >= problem_.max_evaluations || torn()) break;
      factorise(positions_);
    }
    result.evaluations = evaluations;
    return result;
  }

  Step run_level(int level) {
    factorisations_ = 0;
    fresh_ = true;
    predict(level);
    const MinimiserReport result = minimise_level(level);

    Step step;
    step.level = level;
    step.converged = result.converged;
    step.positions = positions_;
    step.forces = atom_forces_;
    step.factorised_at = factorised_at_;
    const VectorXd x = positions_.head(free_dofs());
    const double dead_force = force_control() ? problem_.levels[level] : 0.0;
    step.conjugate_depth_A = pattern_.conjugate_depth(x);
    step.depth_A = -LoadPattern(PointLoad{}, sheet_).direction().dot(x);
    step.force_eV_per_A = force_control() ? dead_force : -result.multiplier;
    step.energy_eV = result.last.energy - dead_force * pattern_.direction().dot(x) - flat_energy_;
    step.max_force_eV_per_A = result.max_force;
    step.balance_relative = balance(step);
    step.force_error_relative =
        std::abs(result.energy_residual / (step.force_eV_per_A * step.conjugate_depth_A));
    step.longest_bond_A = longest_bond(sheet_, positions_);
    step.evaluations = result.evaluations;
    step.factorisations = factorisations_;
    if (!result.converged) report_.reason = result.reason;
    return step;
  }

  /// All forces among the atoms cancel, so the clamped ring's reaction is minus the sum over the free atoms.
  double balance(const Step& step) const {
    double free_z = 0;
    for (int i = 0; i < sheet_.free_atoms; ++i) free_z += step.forces[3 * i + 2];
    return std::abs((free_z - step.force_eV_per_A) / step.force_eV_per_A);
  }

  /// Rupture and artefact come first: a search that fails among them is no failure of the path.
  void end_reached(const Step& step) {
    if (step.longest_bond_A >= ruptured_bond_A) {
      report_.ended = Ended::rupture;
      report_.reason = "a bond of the sheet has broken";
    } else if (step.longest_bond_A >= problem_.potential.artefact_bond_A &&
               !(step.converged && problem_.past_artefact)) {
      report_.ended = Ended::artefact;
      report_.reason = "the longest bond has reached the potential's cut-off switch";
    } else if (!step.converged) {
      report_.ended = Ended::not_converged;
    }
  }

  const Problem& problem_;
  const Sheet& sheet_;
  ForceField& force_field_;
  const PathCallbacks& callbacks_;
  LoadPattern pattern_;
  SpringNetwork network_;
  VectorXd positions_, atom_forces_, factorised_at_;
  std::vector<PathState> states_;
  double flat_energy_ = 0;
  int factorisations_ = 0, first_evaluations_ = 0;
  double factor_parameter_ = 0;  ///< path parameter that the factor was made for
  bool factor_is_tired_ = true;  ///< no factor yet
  bool fresh_ = true;
  Report report_;
};

}  // namespace

Sheet make_sheet(const Problem& problem) {
  return make_sheet(problem.radius_A, problem.card.a0_A, problem.biaxial_strain,
                    problem.potential.interaction_range_A);
}

Report follow_path(const Problem& problem, const std::string& log_file, const std::vector<Step>& finished,
                   const PathCallbacks& callbacks, const MpiSession& session) {
  const Sheet sheet = make_sheet(problem);
  ForceField forces(problem.potential, box_around(sheet), sheet.positions, log_file);
  if (session.rank() != 0) {
    forces.serve();
    return {};
  }
  return Path(problem, sheet, forces, callbacks).follow(finished);
}

}  // namespace atomistic
