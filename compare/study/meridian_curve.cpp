#include "compare/study/meridian_curve.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>

#include "compare/base/interrupt.hpp"
#include "compare/study/curves.hpp"

namespace validate {
namespace {

/// What a path left behind beside its run.
struct Followed {
  membrane::Report report;
  bool left_the_law = false;  ///< its last bond is where the curve need not go on
  double smallest_stiffness_eV_per_A2 = std::numeric_limits<double>::infinity();  ///< of the law, in the last state
};

/// Smallest eigenvalue of dS/dE along the meridian.
double smallest_stiffness(const membrane::Law& law, const std::vector<membrane::MeridianPoint>& points) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const membrane::MeridianPoint& p : points) {
    const membrane::Voigt strain(p.radial_strain, p.hoop_strain, 0);
    const Eigen::Matrix3d tangent = std::visit([&](const auto& l) { return l(strain).tangent_eV_per_A2; }, law);
    smallest = std::min(smallest, Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(tangent).eigenvalues()[0]);
  }
  return smallest;
}

Followed follow(ContinuumExperiment& e, const membrane::Problem& problem) {
  Followed followed;
  followed.report = membrane::solve(problem, [&](const membrane::Step& step) {
    if (!step.converged) return false;
    append(e.run, step, e.longest_bond, e.stretch);
    if (!e.longest_bond) return !interrupted();
    followed.left_the_law = e.run.longest_bond_A.back() >= e.last_bond_A;
    if (!followed.left_the_law)
      followed.smallest_stiffness_eV_per_A2 = smallest_stiffness(problem.law, step.on_meridian());
    return !followed.left_the_law && !interrupted();
  });
  return followed;
}

/// Number of states found before the end: without the one that has left the law.
std::size_t inside(const ContinuumExperiment& e, const Followed& followed) {
  return e.run.depth_A.size() - (followed.left_the_law ? 1 : 0);
}

/// Whether the states found end short of what the law is calibrated to.
bool ends_within(const ContinuumExperiment& e, const Followed& followed) {
  const std::size_t count = inside(e, followed);
  return count > 0 && e.run.longest_bond_A[count - 1] < e.law_holds_to_A;
}

/// The levels that were reached, and finer ones up to the first that was not; none where the levels do not rise.
std::vector<double> finer_at_the_end(const std::vector<double>& levels, std::size_t reached) {
  constexpr int parts = 16;
  if (reached == 0 || reached >= levels.size() || !(levels[reached] > levels[reached - 1])) return {};
  std::vector<double> finer(levels.begin(), levels.begin() + static_cast<std::ptrdiff_t>(reached));
  for (int k = 1; k <= parts; ++k)
    finer.push_back(std::lerp(levels[reached - 1], levels[reached], k / static_cast<double>(parts)));
  return finer;
}

void drop_last_state(Run& run) {
  for (std::vector<double>* column : {&run.depth_A, &run.conjugate_depth_A, &run.force_eV_per_A, &run.energy_eV,
                                      &run.longest_bond_A, &run.pressure_eV_per_A3, &run.volume_A3})
    if (!column->empty()) column->pop_back();
  run.converged.pop_back();
  run.continuum().newton_iterations.pop_back();
}

/// How the curve of a calibrated law ended before its last level.
void say_how_it_ended(ContinuumExperiment& e, const Followed& followed) {
  constexpr double lost_share = 0.05;  // of E·h: next to nothing beside what the flat sheet has
  const bool within = ends_within(e, followed);
  const bool soft = followed.smallest_stiffness_eV_per_A2 < lost_share * e.run.Eh_eV_per_A2;
  if (within && !soft) return;  // a solver's failure
  if (within && followed.left_the_law) drop_last_state(e.run);
  const double bond_A = e.run.longest_bond_A.back();
  e.run.ended = within ? Ended::rupture : Ended::calibration_end;
  e.run.ended_reason =
      within ? fmt::format(
                   "the sheet tears: no equilibrium beyond a longest bond of {:.2f} Å, where the law's smallest "
                   "stiffness is {:.2f} eV/Å²",
                   bond_A, followed.smallest_stiffness_eV_per_A2)
             : fmt::format("the law is calibrated to a longest bond of {:.2f} Å, the strains predict {:.2f} Å",
                           e.law_holds_to_A, bond_A);
}

}  // namespace

void solve_on_meridian(ContinuumExperiment& e, bool to_the_end) {
  const Run blank = e.run;
  Followed followed = follow(e, e.problem);
  const auto early = [&] { return !interrupted() && (!followed.report.converged || followed.left_the_law); };
  if (to_the_end && e.longest_bond && early() && ends_within(e, followed)) {
    membrane::Problem finer = e.problem;
    finer.levels = finer_at_the_end(e.problem.levels, inside(e, followed));
    if (!finer.levels.empty()) {
      e.run = blank;
      followed = follow(e, finer);
    }
  }
  close(e.run, followed.report);
  if (e.longest_bond && early() && !e.run.longest_bond_A.empty()) say_how_it_ended(e, followed);
}

}  // namespace validate
