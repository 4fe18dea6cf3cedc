// What makes a problem unsolvable before anything is computed, on any discretisation.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "membrane/base/refusal.hpp"
#include "membrane/check_discretisation.hpp"
#include "membrane/laws/principal.hpp"
#include "membrane/problem.hpp"

namespace membrane {
namespace {

void check_prestress(const Problem& problem) {
  const Eigen::Matrix2d& prestress = problem.prestress_eV_per_A2;
  for (double component : prestress.reshaped())
    if (!std::isfinite(component)) refuse("prestress_eV_per_A2", component, "every component must be finite");
  if (prestress(0, 1) != prestress(1, 0))
    refuse("prestress_eV_per_A2(0,1)", prestress(0, 1), "must equal component (1,0): the tensor is symmetric");
  const auto* rectangle = std::get_if<RectangleSheet>(&problem.sheet);
  if (rectangle && rectangle->extent == Extent::quarter && prestress(0, 1) != 0)
    refuse("prestress_eV_per_A2(0,1)", prestress(0, 1), "breaks the symmetry of a quarter: mesh the full sheet");
}

/// The symmetry planes of a quarter must be the lattice's, too: zigzag and armchair follow each other every 30°.
template <MaterialLaw L>
void check_directions(const L& law, const Problem& problem) {
  if constexpr (DirectionalLaw<L>) {
    if (!is_quarter(problem.sheet)) return;
    const double mirrors = law.zigzag_rad / (std::numbers::pi / 6);
    if (std::abs(mirrors - std::round(mirrors)) > 1e-9)
      refuse(
          "law.zigzag_rad", law.zigzag_rad,
          "must be a multiple of 30 degrees on a quarter, or its planes are no mirrors of the lattice: mesh the full "
          "sheet");
    if (problem.prestress_eV_per_A2(0, 1) != 0)
      refuse("prestress_eV_per_A2(0,1)", problem.prestress_eV_per_A2(0, 1),
             "breaks the symmetry of a quarter: mesh the full sheet");
  }
}

/// Acts through its work alone, and only patterns and a sphere begin on a sheet that is stretched already.
void check_edge_tension(const Problem& problem) {
  const double tension = problem.edge_tension_eV_per_A2;
  if (!(tension >= 0) || !std::isfinite(tension))
    refuse("edge_tension_eV_per_A2", tension, "must be finite and not negative: a sheet that is pushed in buckles");
  const EdgeElasticity& edge = problem.edge;
  if (!std::isfinite(edge.stress_eV_per_A) || !std::isfinite(edge.stiffness_eV_per_A))
    refuse("edge", edge.stress_eV_per_A, "stress and stiffness must be finite");
  if (tension == 0 && (edge.stress_eV_per_A != 0 || edge.stiffness_eV_per_A != 0))
    refuse("edge", edge.stress_eV_per_A, "an edge of its own needs a tension beside it");
  if (tension == 0) return;
  const auto supports = supports_of(problem.sheet);
  if (std::ranges::none_of(supports, [](const auto& s) { return s.second == Support::sliding; }))
    refuse("edge_tension_eV_per_A2", tension, "needs an edge that slides in its plane: the others do not give way");
  if (problem.pressure_eV_per_A3 != 0)
    refuse("pressure_eV_per_A3", problem.pressure_eV_per_A3, "must be 0 where an edge is under tension");
  if (problem.prestress_eV_per_A2 != Eigen::Matrix2d::Zero())
    refuse("prestress_eV_per_A2", problem.prestress_eV_per_A2(0, 0), "must be 0 where an edge is under tension");
  const Action action = action_of(problem.load);
  if (std::holds_alternative<FollowerPressure>(action) || std::holds_alternative<EdgeMotion>(action))
    refuse("load", "a pressure or a moved edge", "must be a dead force or a sphere where an edge is under tension");
}

bool compressive(const Eigen::Matrix2d& prestress) {
  return Principal(prestress(0, 0), prestress(1, 1), prestress(0, 1)).smaller < 0;
}

void check_levels(const Problem& problem) {
  if (problem.levels.empty())
    refuse("levels", "[]", "at least one is needed: without a load there is nothing to solve");
  const bool bulged = problem.pressure_eV_per_A3 != 0;  // then depths of either sign make sense
  const bool compressed = compressive(problem.prestress_eV_per_A2);
  if (compressed && !bulged && *std::min_element(problem.levels.begin(), problem.levels.end()) == 0)
    refuse("prestress_eV_per_A2", problem.prestress_eV_per_A2.reshaped().transpose(),
           "is compressive, and nothing loads the sheet at level 0: it hangs slack, or buckles if it is not "
           "relaxed");
  for (double level : problem.levels)
    if (!std::isfinite(level) || (!bulged && !(level > 0)))
      refuse("levels", level, bulged ? "every level must be finite" : "every level must be positive and finite");
}

}  // namespace

void check(const Problem& problem) {
  check(problem.sheet);
  std::visit([]<MaterialLaw L>(const L& law) { law.check(); }, problem.law);
  if (problem.bending) problem.bending->check();
  if (problem.bending && problem.relaxed)
    refuse("relaxed", "true", "must be false for a sheet that bends: bending is what limits its compression");
  check_prestress(problem);
  std::visit([&]<MaterialLaw L>(const L& law) { check_directions(law, problem); }, problem.law);
  if (!std::isfinite(problem.pressure_eV_per_A3))
    refuse("pressure_eV_per_A3", problem.pressure_eV_per_A3, "must be finite");
  if (problem.pressure_eV_per_A3 != 0) require_closed(problem.sheet, "pressure_eV_per_A3");
  check_edge_tension(problem);
  const Widest widest = widest_load(problem);
  const LoadSetting setting{problem.sheet, problem.control, problem.pressure_eV_per_A3, widest.patch_A,
                            widest.sphere_A};
  std::visit([&]<LoadKind L>(const L& load) { load.check(setting); }, problem.load);
  if (!(problem.record_radius_A >= 0 && problem.record_radius_A < inner_radius_A(problem.sheet)))
    refuse("record_radius_A", problem.record_radius_A, "must be at least 0 and below the sheet's radius");
  check_levels(problem);
  check_discretisation(problem);
}

}  // namespace membrane
