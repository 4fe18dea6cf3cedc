// What makes a round sheet's problem unsolvable before anything is computed.
#include <cmath>

#include "membrane/base/refusal.hpp"
#include "membrane/meridian/sheet.hpp"

namespace membrane::axisymmetric {
namespace {

bool positive(double x) { return x > 0 && std::isfinite(x); }

struct CheckLoad {
  double sheet_radius;
  void operator()(const PointLoad&) const {}
  void operator()(const PressureLoad&) const {}
  void operator()(const DiscLoad& disc) const {
    if (!positive(disc.radius_A) || disc.radius_A > sheet_radius)
      refuse("load.radius_A", disc.radius_A, "must be positive and at most radius_A");
  }
  void operator()(const ProfileLoad& profile) const {
    operator()(DiscLoad{profile.radius_A});
    if (!profile.density) refuse("load.density", "none", "a profile needs its density");
  }
  void operator()(const SphereLoad& sphere) const {
    if (!positive(sphere.radius_A)) refuse("load.radius_A", sphere.radius_A, "must be positive and finite");
  }
};

void check_levels(const SheetProblem& problem) {
  if (problem.levels.empty()) refuse("levels", "[]", "at least one depth, force or pressure is needed");
  for (double level : problem.levels)
    if (!positive(level)) refuse("levels", level, "every level must be positive and finite");
}

void check_pressure(const SheetProblem& problem) {
  const double pressure = problem.pressure_eV_per_A3;
  if (!std::isfinite(pressure)) refuse("pressure_eV_per_A3", pressure, "must be finite");
  if (pressure == 0) return;
  if (std::holds_alternative<PressureLoad>(problem.load))
    refuse("pressure_eV_per_A3", pressure, "must be 0 where the levels are pressures");
  if (problem.control == Control::force)
    refuse("control", "force", "must be conjugate_depth beside a background pressure");
}

}  // namespace

void check(const SheetProblem& problem) {
  if (!positive(problem.radius_A)) refuse("radius_A", problem.radius_A, "must be positive and finite");
  std::visit([](const auto& law) { law.check(); }, problem.law);
  if (!is_isotropic(problem.law))
    refuse("law", "with directions", "must be isotropic: a sheet that differs from side to side is not round");
  const double bending = problem.bending_modulus_eV;
  if (!(bending >= 0) || !std::isfinite(bending))
    refuse("bending_modulus_eV", bending, "must be finite and not negative");
  if (bending > 0 && problem.relaxed)
    refuse("relaxed", "true", "must be false for a sheet that bends: bending is what limits its compression");
  if (!std::isfinite(problem.pretension_eV_per_A2))
    refuse("pretension_eV_per_A2", problem.pretension_eV_per_A2, "must be finite");
  if (!(problem.record_radius_A >= 0 && problem.record_radius_A <= problem.radius_A))
    refuse("record_radius_A", problem.record_radius_A, "must lie between 0 and radius_A");
  if (!(problem.refinement >= 0.1 && problem.refinement <= 100))
    refuse("refinement", problem.refinement, "must lie between 0.1 and 100");
  std::visit(CheckLoad{problem.radius_A}, problem.load);
  check_pressure(problem);
  check_levels(problem);
}

}  // namespace membrane::axisymmetric
