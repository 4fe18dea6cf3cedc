#include "membrane/meridian/path.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "membrane/follow_levels.hpp"
#include "membrane/meridian/newton.hpp"
#include "membrane/meridian/predictor.hpp"
#include "membrane/meridian/record.hpp"
#include "membrane/meridian/round_problem.hpp"
#include "membrane/meridian/setup.hpp"
#include "membrane/meridian/tuning.hpp"

namespace membrane::meridian {
namespace {

class Path {
 public:
  explicit Path(const Problem& problem)
      : problem_(problem),
        assembly_(assembly_of(problem)),
        newton_(assembly_),
        pattern_(pattern_of(problem, assembly_)),
        predictor_(tip_shape(problem, assembly_, pattern_),
                   problem.pressure_eV_per_A3 == 0 && problem.edge_tension_eV_per_A2 == 0) {}

  Report follow(const OnStep& on_step) {
    report_.elements = assembly_.element_count();
    if (begin()) go_through_levels(on_step);
    report_.factorisations = newton_.factorisations();
    report_.assemblies = assembly_.passes();
    return report_;
  }

 private:
  struct Attempt {
    Equilibrium equilibrium;
    Known known;
  };

  /// What is there before the load comes first: the rim's tension, the constant pressure, as a path of its own.
  bool begin() {
    if (problem_.edge_tension_eV_per_A2 > 0) return stretch();
    return inflate();
  }

  /// The flat sheet, its rim pulled outwards.
  bool stretch() {
    Attempt at{{}, {0, 0, evenly_stretched(problem_, assembly_)}};
    find({}, at);
    report_.reason = "the rim's tension: " + at.equilibrium.reason;
    if (!at.equilibrium.converged) return false;
    flat_energy_ = record(problem_, assembly_, at.known.x).energy_eV;
    predictor_.add(at.known);
    return true;
  }

  bool inflate() {
    if (problem_.pressure_eV_per_A3 == 0) return true;
    const Attempt end = reach_pressure(problem_.pressure_eV_per_A3);
    report_.reason = "the constant pressure: " + end.equilibrium.reason;
    return end.equilibrium.converged;
  }

  void go_through_levels(const OnStep& on_step) {
    follow_levels(
        problem_.levels, unit(), on_step, report_,
        [&](double value) {
          iterations_ = 0;
          return level(value);
        },
        [&](int i, const Attempt& end) { return step(i, end); });
  }

  const char* unit() const { return pressed_ ? "eV/Å³" : problem_.control == Control::force ? "eV/Å" : "Å"; }

  Attempt level(double value) {
    if (pressed_) return reach_pressure(value);
    return problem_.control == Control::force ? reach_force(value) : reach_depth(value);
  }

  /// Goes to a value of what is controlled from where the path stands.
  template <class Try, class Here>
  Attempt reach(double value, Try attempt, Here here) {
    const bool first = !predictor_.last();
    const int most =
        newton_.factorisations() + (first ? PathTuning::most_for_the_first : PathTuning::most_factorisations);
    return membrane::reach(
        value, attempt, [&](double missed) { return predictor_.last() ? 0.5 * (here() + missed) : missed / 8; },
        [&](int cuts) { return cuts < PathTuning::most_cuts && newton_.factorisations() < most; },
        [&](double missed, double next, const Equilibrium& why) {
          report_.cuts.push_back(cut_note(missed, next, why));
        });
  }

  Attempt reach_pressure(double pressure) {
    return reach(
        pressure, [&](double p) { return bulge(p); }, [&] { return pressure_; });
  }

  Attempt reach_depth(double depth) {
    return reach(
        depth, [&](double d) { return attempt(d); }, [&] { return predictor_.last()->depth_A; });
  }

  /// The sheet under pressure alone.
  Attempt bulge(double pressure) {
    std::get<Pressure>(assembly_.terms()[pressure_term]).pressure_eV_per_A3 = pressure;
    Attempt at;
    at.known.x = predictor_.last() ? predictor_.last()->x : bulge_shape(problem_, assembly_, pressure);
    find({}, at);
    at.known.depth_A = conjugate_depth(pattern_, at.known.x);
    if (at.equilibrium.converged) {
      predictor_.add(at.known);
      pressure_ = pressure;
    }
    return at;
  }

  /// Secants in log force over log depth, which is nearly straight.
  Attempt reach_force(double force) {
    const bool loaded = predictor_.last() && predictor_.last()->force_eV_per_A > 0;
    Attempt at = reach_depth(loaded ? predictor_.depth_at(force) : start_depth(problem_, force));
    for (int i = 0; i < PathTuning::most_corrections && at.equilibrium.converged; ++i) {
      if (std::abs(at.known.force_eV_per_A - force) <= PathTuning::force_tolerance * force) return at;
      if (!(at.known.force_eV_per_A > 0)) break;
      at = reach_depth(predictor_.depth_at(force));
    }
    if (at.equilibrium.converged) at.equilibrium.reason = "no depth was found at which the load has this force";
    at.equilibrium.converged = false;
    return at;
  }

  Attempt attempt(double depth) {
    Attempt at{{}, {depth, 0, predictor_.at(depth)}};
    if (assembly_.contact()) {
      press(at);
    } else {
      find(pattern_, at);
      at.known.force_eV_per_A = at.equilibrium.force_eV_per_A;
    }
    if (at.equilibrium.converged) predictor_.add(at.known);
    return at;
  }

  /// The sphere at a depth: an interior point method.
  void press(Attempt& at) {
    SphereContact& contact = *assembly_.contact();
    contact.depth_A = at.known.depth_A;
    clear_sphere(at.known.x);
    const double area = std::numbers::pi * contact.radius_A * contact.radius_A;
    const double unit = sheet_energy(at.known.x) / area;
    double share = ContactTuning::first_barrier;
    contact.barrier_eV_per_A2 = share * unit;
    assembly_.start_pressures(at.known.x);
    for (;;) {
      find({}, at);
      if (!at.equilibrium.converged) return;
      const Bearing bearing = bearing_of(at.known.x);
      at.known.force_eV_per_A = bearing.force_eV_per_A;
      const double farther =
          ContactTuning::last_slack * depth_scale() / bearing.gap_A;  // the gap is proportional to the barrier
      if (farther > ContactTuning::close_enough || share < ContactTuning::no_contact) return;
      share *= std::max(farther, std::min(ContactTuning::barrier_decay, std::sqrt(share)));
      contact.barrier_eV_per_A2 = share * unit;
    }
  }

  /// Of stretching and bending: the pressure's has either sign.
  double sheet_energy(const Eigen::VectorXd& x) {
    Eigen::VectorXd gradient;
    assembly_.contact()->barrier_eV_per_A2 = 0;
    assembly_.energy(x, gradient);
    return std::abs(assembly_.parts()[stretching_term]) + assembly_.parts()[bending_term];
  }

  /// A pressure can lift the sheet to where the sphere's depth is zero or less.
  double depth_scale() const {
    const SphereContact& contact = *assembly_.contact();
    return std::max(std::abs(contact.depth_A), 1e-3 * contact.radius_A);
  }

  /// What the sphere bears, and across which gap: the mean over the rings by the square of their forces.
  struct Bearing {
    double force_eV_per_A = 0, gap_A = 0;
  };
  Bearing bearing_of(const Eigen::VectorXd& x) const {
    const SphereContact& contact = *assembly_.contact();
    double vertical = 0, squares = 0, weighted = 0;
    assembly_.over_contact(x, [&](const Ring& ring, const LocalState& y) {
      const double gap = contact.gap(ring, y);
      const double force = ring.area_A2 * contact.barrier_eV_per_A2 / gap;
      vertical += force * contact.normal(ring, y)[W];
      squares += force * force;
      weighted += force * force * gap;
    });
    return {vertical, weighted / squares};
  }

  /// Deepens a shape until it is clear of the sphere.
  void clear_sphere(Eigen::VectorXd& x) const {
    const SphereContact& contact = *assembly_.contact();
    double farther = 1e-3 * std::min(depth_scale(), contact.radius_A);
    const auto least_gap = [&](const Eigen::VectorXd& shape) {
      double least = std::numeric_limits<double>::infinity();
      assembly_.over_contact(
          shape, [&](const Ring& ring, const LocalState& y) { least = std::min(least, contact.gap(ring, y)); });
      return least;
    };
    const Eigen::VectorXd from = x;
    for (; !(least_gap(x) > 0); farther *= 2) x = from + farther * predictor_.unit();
  }

  void find(const Eigen::VectorXd& pattern, Attempt& at) {
    at.equilibrium = newton_.solve(pattern, at.known.x);
    iterations_ += at.equilibrium.iterations;
  }

  Step step(int level, const Attempt& end) {
    Step step = record(problem_, assembly_, end.known.x, flat_energy_);
    step.level = level;
    step.converged = end.equilibrium.converged;
    const double area = std::numbers::pi * std::pow(assembly_.nodes().back(), 2);
    step.conjugate_depth_A = pressed_ ? step.volume_A3 / area : end.known.depth_A;
    step.force_eV_per_A = end.known.force_eV_per_A;
    step.relative_residual = end.equilibrium.relative_residual;
    step.newton_iterations = iterations_;
    return step;
  }

  const Problem& problem_;
  bool pressed_ = traits_of(problem_).pressure;  ///< the levels are pressures
  Assembly assembly_;
  Newton newton_;
  Eigen::VectorXd pattern_;
  Predictor predictor_;
  Report report_;
  double flat_energy_ = 0;  ///< of the sheet that its rim alone stretches, eV
  double pressure_ = 0;     ///< of the last bulge that was found, eV/Å³
  int iterations_ = 0;      ///< on the way to the present level, cut-backs included
};

}  // namespace

Report follow(const Problem& problem, const OnStep& on_step) { return Path(problem).follow(on_step); }

}  // namespace membrane::meridian
