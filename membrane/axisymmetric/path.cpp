// Follows the levels of a round sheet: solve() of sheet.hpp.
#include <cmath>
#include <sstream>
#include <utility>

#include "membrane/axisymmetric/newton.hpp"
#include "membrane/axisymmetric/predictor.hpp"
#include "membrane/axisymmetric/record.hpp"
#include "membrane/axisymmetric/setup.hpp"
#include "membrane/axisymmetric/sheet.hpp"

namespace membrane::axisymmetric {
namespace {

constexpr int most_cuts = 12;                // failed attempts on the way to one level …
constexpr int most_factorisations = 30000;   // … and work on it: most take a hundred, hard first levels thousands
constexpr int most_corrections = 40;
constexpr double force_tolerance = 1e-10;
/// A stiffness of the contact on the way to a rigid one: of the rings, over E·h, or of a foundation, over E·h and the
/// inverse square of the sphere's radius.
struct Stride {
  double rings = 0, foundation = 0;
};
/// Ways there, tried one after the other. A foundation pulls no ring like a point, which a law that softens could not
/// bear; rings alone reach smaller spheres. With the last stiffness a sphere is entered by some 1e-7 of its radius at most.
const std::vector<Stride> ways_to_contact[] = {{{0, 40}, {1e2, 0}, {1e5, 0}},
                                               {{1, 0}, {1e2, 0}, {1e5, 0}},
                                               {{0, 40}, {0, 1e3}, {1e2, 0}, {1e3, 0}, {1e4, 0}, {1e5, 0}}};

class Path {
 public:
  explicit Path(const SheetProblem& problem)
      : problem_(problem),
        assembly_(assembly_of(problem)),
        newton_(assembly_),
        pattern_(pattern_of(problem, assembly_)),
        predictor_(tip_shape(problem, assembly_, pattern_), problem.pressure_eV_per_A3 == 0) {}

  SheetReport follow(const OnSheetStep& on_step) {
    SheetReport report{true, "every level was reached", assembly_.element_count(), 0};
    if (problem_.pressure_eV_per_A3 != 0) reach_pressure(problem_.pressure_eV_per_A3);
    for (std::size_t i = 0; i < problem_.levels.size(); ++i) {
      iterations_ = 0;
      const Attempt end = level(problem_.levels[i]);
      const bool reached = end.equilibrium.converged;
      const bool go_on = on_step(step(static_cast<int>(i), end));
      if (reached && go_on) continue;
      report.converged = reached && i + 1 == problem_.levels.size();
      report.reason = reached ? "ended by the caller" : failure(i, end.equilibrium);
      break;
    }
    report.factorisations = newton_.factorisations();
    return report;
  }

 private:
  struct Attempt {
    Equilibrium equilibrium;
    Known known;
  };

  Attempt level(double value) {
    if (std::holds_alternative<PressureLoad>(problem_.load)) return reach_pressure(value);
    return problem_.control == Control::force ? reach_force(value) : reach_depth(value);
  }

  /// Goes to a value of what is controlled from where the path stands; where an attempt fails, a value
  /// between is reached first.
  template <class Try, class Here>
  Attempt reach(double value, Try attempt, Here here) {
    Attempt at = attempt(value);
    std::vector<double> between;  // the next one last
    const int begun = newton_.factorisations();
    const auto goes_on = [&](int cuts) {
      return cuts < most_cuts && newton_.factorisations() - begun < most_factorisations;
    };
    for (int cuts = 0; !at.equilibrium.converged && goes_on(cuts);) {
      const double target = between.empty() ? value : between.back();
      between.push_back(predictor_.last() ? 0.5 * (here() + target) : target / 8);
      ++cuts;
      while (!between.empty() && attempt(between.back()).equilibrium.converged) between.pop_back();
      if (between.empty()) at = attempt(value);
    }
    return at;
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
    Attempt at = reach_depth(predictor_.last() ? predictor_.depth_at(force) : start_depth(problem_, force));
    for (int i = 0; i < most_corrections && at.equilibrium.converged; ++i) {
      if (std::abs(at.known.force_eV_per_A - force) <= force_tolerance * force) return at;
      if (!(at.known.force_eV_per_A > 0)) break;
      at = reach_depth(predictor_.depth_at(force));
    }
    if (at.equilibrium.converged)
      at.equilibrium.reason = "no depth was found at which the load has this force";
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

  /// The sphere at a depth.
  void press(Attempt& at) {
    const Eigen::VectorXd start = at.known.x;
    for (const std::vector<Stride>& way : ways_to_contact) {
      at.known.x = start;
      press(at, way);
      if (at.equilibrium.converged) return;
    }
  }

  void press(Attempt& at, const std::vector<Stride>& way) {
    SphereContact& contact = *assembly_.contact();
    contact.depth_A = at.known.depth_A;
    const double modulus = sheet_modulus(problem_);
    for (const Stride& stride : way) {
      contact.stiffness_eV_per_A2 = stride.rings * modulus;
      contact.foundation_eV_per_A4 = stride.foundation * modulus / (contact.radius_A * contact.radius_A);
      if (stride.foundation > 0 || &stride == &way.front() || !find_by_whole_steps(at)) find({}, at);
      if (!at.equilibrium.converged) return;
    }
    at.known.force_eV_per_A = assembly_.contact_sum(
        at.known.x, [&](const Ring& ring, const LocalState& y) { return contact.force(ring, y); });
  }

  /// From a start that is near; else at is left as it was.
  bool find_by_whole_steps(Attempt& at) {
    Eigen::VectorXd x = at.known.x;
    const Equilibrium found = newton_.solve_by_whole_steps(x);
    iterations_ += found.iterations;
    if (found.converged) {
      at.equilibrium = found;
      at.known.x = std::move(x);
    }
    return found.converged;
  }

  void find(const Eigen::VectorXd& pattern, Attempt& at) {
    at.equilibrium = newton_.solve(pattern, at.known.x);
    iterations_ += at.equilibrium.iterations;
  }

  SheetStep step(int level, const Attempt& end) {
    SheetStep step = record(problem_, assembly_, end.known.x);
    step.level = level;
    step.converged = end.equilibrium.converged;
    step.conjugate_depth_A = std::holds_alternative<PressureLoad>(problem_.load) ? 0 : end.known.depth_A;
    step.force_eV_per_A = end.known.force_eV_per_A;
    step.relative_residual = end.equilibrium.relative_residual;
    step.iterations = iterations_;
    return step;
  }

  std::string failure(std::size_t level, const Equilibrium& at) const {
    std::ostringstream text;
    text << "level " << level << " (" << problem_.levels[level] << "): " << at.reason
         << "; relative residual " << at.relative_residual;
    return text.str();
  }

  const SheetProblem& problem_;
  Assembly assembly_;
  Newton newton_;
  Eigen::VectorXd pattern_;
  Predictor predictor_;
  double pressure_ = 0;  ///< of the last bulge that was found, eV/Å³
  int iterations_ = 0;   ///< on the way to the present level, cut-backs included
};

}  // namespace

SheetReport solve(const SheetProblem& problem, const OnSheetStep& on_step) {
  check(problem);
  return Path(problem).follow(on_step);
}

}  // namespace membrane::axisymmetric
