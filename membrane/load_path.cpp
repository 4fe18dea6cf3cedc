// Follows the levels of a problem from the flat sheet: solve() of problem.hpp.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "membrane/assembly.hpp"
#include "membrane/check.hpp"
#include "membrane/grading.hpp"
#include "membrane/laws/prestress.hpp"
#include "membrane/laws/principal.hpp"
#include "membrane/loads/pattern.hpp"
#include "membrane/newton.hpp"
#include "membrane/predictor.hpp"
#include "membrane/problem.hpp"
#include "membrane/quarter_disc.hpp"
#include "membrane/refusal.hpp"
#include "membrane/start.hpp"

namespace membrane {
namespace {

constexpr int most_cuts = 10;  // failed attempts on the way to one level

double load_radius(const Load& load) {
  const auto* disc = std::get_if<DiscLoad>(&load);
  return disc ? disc->radius_A : 0;
}

/// A round sheet of an isotropic law under a round load looks the same from every side: the prestress is
/// turned to its own axes, which makes the two planes of the quarter planes of symmetry for any prestress.
Material material_of(const Problem& problem) {
  const Eigen::Vector2d principal =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(problem.prestress_eV_per_A2).eigenvalues();
  const Voigt prestress(principal[0], principal[1], 0);
  const Voigt offset =
      std::visit([&](const auto& law) { return offset_strain(law, prestress); }, problem.law);
  if (!offset.allFinite())
    refuse("prestress_eV_per_A2", prestress.head<2>().transpose(),
           "the law cannot carry these principal values");
  return {problem.law, offset, problem.relaxed};
}

/// Where a search for an equilibrium ended, converged or not.
struct Attempt {
  Equilibrium equilibrium;
  Eigen::VectorXd u;           ///< Å
  double conjugate_depth = 0;  ///< Å
};

class LoadPath {
 public:
  explicit LoadPath(const Problem& problem)
      : problem_(problem),
        disc_(quarter_disc(graded_radii({problem.sheet.radius_A, load_radius(problem.load),
                                         problem.record_radius_A, problem.sheet.rings}))),
        pattern_(make_pattern(problem.load, disc_.mesh)),
        record_(mean_on_circle(disc_, problem.record_radius_A)),
        assembly_(disc_.mesh, material_of(problem)),
        newton_(disc_.mesh, assembly_, pattern_.direction()) {}

  Report follow(const OnStep& on_step) {
    Report report;
    report.triangles = static_cast<int>(disc_.mesh.triangles.size());
    report.reason = "every level was reached";
    report.converged = true;
    for (std::size_t i = 0; i < problem_.levels.size(); ++i) {
      iterations_ = 0;
      const double level = problem_.levels[i];
      const Attempt end = reach(control_value(level));
      const bool reached = end.equilibrium.converged;
      const bool go_on = on_step(step(static_cast<int>(i), end));
      if (reached && go_on) continue;
      report.converged = reached && i + 1 == problem_.levels.size();
      report.reason = reached ? "ended by the caller" : failure(i, end.equilibrium);
      break;
    }
    report.factorisations = newton_.factorisations();
    report.assemblies = assembly_.passes();
    return report;
  }

 private:
  /// A level as the meshed part sees it.
  double control_value(double level) const {
    return problem_.control == Control::force ? level / disc_.mesh.copies : level;
  }

  /// Where the path stands in the controlled quantity.
  double here() const {
    if (predictor_.empty()) return 0;
    const PathPoint& last = predictor_.last();
    return problem_.control == Control::force ? last.force_eV_per_A : last.conjugate_depth_A;
  }

  /// Goes to a value of the controlled quantity; where an attempt fails, a value between is reached first.
  /// Returns the last attempt at the value itself.
  Attempt reach(double value) {
    Attempt at = attempt(value);
    std::vector<double> between;  // unreported stations, the next one last
    for (int cuts = 0; !at.equilibrium.converged && cuts < most_cuts;) {
      const double target = between.empty() ? value : between.back();
      // Half way on the scale on which the sheet's response is a straight line, the logarithmic one.
      between.push_back(predictor_.empty() ? target / 8 : std::sqrt(here() * target));
      ++cuts;
      while (!between.empty() && attempt(between.back()).equilibrium.converged) between.pop_back();
      if (between.empty()) at = attempt(value);
    }
    return at;
  }

  Attempt attempt(double value) {
    Attempt attempt{{}, guess(value), 0};
    attempt.equilibrium = newton_.solve({problem_.control, value}, attempt.u);
    attempt.conjugate_depth = pattern_.weights.dot(transverse(attempt.u));
    iterations_ += attempt.equilibrium.iterations;
    if (attempt.equilibrium.converged)
      predictor_.add({attempt.conjugate_depth, attempt.equilibrium.force_eV_per_A,
                      attempt.equilibrium.compliance, attempt.u});
    return attempt;
  }

  Eigen::VectorXd guess(double value) const {
    const bool by_force = problem_.control == Control::force;
    if (!predictor_.empty())
      return predictor_.displacements(by_force ? predictor_.conjugate_depth(value) : value);
    const double modulus =
        std::visit([](const auto& law) -> double { return law.sheet_modulus_eV_per_A2; }, problem_.law);
    const double depth =
        by_force ? start_depth(value * disc_.mesh.copies, modulus, 0.5 * problem_.prestress_eV_per_A2.trace(),
                               problem_.sheet.radius_A)
                 : value;
    return start_shape(disc_.mesh, pattern_.weights, problem_.sheet.radius_A, load_radius(problem_.load),
                       depth);
  }

  /// −z of every node.
  static Eigen::VectorXd transverse(const Eigen::VectorXd& u) {
    return -u.reshaped(3, u.size() / 3).row(2).transpose();
  }

  double rim_membrane_force(const Eigen::VectorXd& u) const {
    double largest = 0;
    for (int triangle : disc_.mesh.rim_triangles)
      largest = std::max(largest, principal_forces(assembly_.membrane_force(u, triangle)).larger);
    return largest;
  }

  Step step(int level, const Attempt& end) const {
    const int copies = disc_.mesh.copies;
    const Equilibrium& at = end.equilibrium;
    Step step;
    step.level = level;
    step.converged = at.converged;
    step.depth_A = record_.dot(transverse(end.u));
    step.conjugate_depth_A = end.conjugate_depth;
    step.force_eV_per_A = copies * at.force_eV_per_A;
    step.energy_eV = copies * at.energy_eV;
    step.relative_residual = at.relative_residual;
    step.rim_membrane_force_eV_per_A2 = rim_membrane_force(end.u);
    step.newton_iterations = iterations_;
    return step;
  }

  std::string failure(std::size_t level, const Equilibrium& at) const {
    std::ostringstream text;
    text << "level " << level << " (" << problem_.levels[level]
         << (problem_.control == Control::force ? " eV/Å" : " Å") << "): " << at.reason
         << "; relative residual " << at.relative_residual;
    return text.str();
  }

  const Problem& problem_;
  QuarterDisc disc_;
  Pattern pattern_;
  Eigen::VectorXd record_;
  Assembly assembly_;
  Newton newton_;
  Predictor predictor_;
  int iterations_ = 0;  ///< on the way to the present level, cut-backs included
};

}  // namespace

Report solve(const Problem& problem, const OnStep& on_step) {
  check(problem);
  return LoadPath(problem).follow(on_step);
}

}  // namespace membrane
