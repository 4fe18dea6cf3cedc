#include "compare/cli/plan.hpp"

#include <fmt/core.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "compare/documents/texts/json.hpp"
#include "membrane/problem.hpp"

namespace validate {
namespace {

/// Graphene's lattice constant, for counting before the potential's own is known.
constexpr double typical_a0_A = 2.46;

/// Measured averages: evaluations for a level, and AIREBO's time for an atom's force on one core (the dearest
/// potential).
constexpr double evaluations_per_level = 9, dearest_force_s = 5e-6, factor_and_solve_s = 3e-6;

std::string atoms_plan(const Case& c, const atomistic::Potential& potential, std::size_t levels, int cores) {
  const double outer = c.radius_A + potential.interaction_range_A;
  const double atoms = std::numbers::pi * outer * outer / (std::numbers::sqrt3 / 4 * typical_a0_A * typical_a0_A);
  const double curves = static_cast<double>(c.loads.size()),
               evaluations = evaluations_per_level * static_cast<double>(levels);
  const double serial_s = curves * evaluations * atoms * (dearest_force_s + factor_and_solve_s);
  return fmt::format(
      "atoms: about {:.0f} ({:.1f} Å wide clamped ring), {:.0f} curve(s) of {} depths or more\n"
      "estimate: at most about {:.0f} s on {} core(s) (AIREBO; REBO and Tersoff take a third)\n",
      atoms, potential.interaction_range_A, curves, levels, 3 + serial_s / std::min<double>(cores, curves), cores);
}

}  // namespace

std::string plan_text(const Case& c, const std::optional<PotentialFile>& potential, const AtomsLaunch& launch) {
  const std::size_t levels = c.forces_eV_per_A.empty() ? depth_levels(c).size() : c.forces_eV_per_A.size();
  std::string text = "case: " + document(c).dump(1) + "\n";
  if (potential) text += fmt::format("potential file: {}\n", potential->potential.file);
  if (c.models != Models::atomistic) {
    const int rings = membrane::DiscSheet{}.rings;
    text += fmt::format("membrane: {} triangles on a quarter, {} curve(s) of {} levels\n", rings * rings,
                        c.loads.size() * (potential ? 2 : 1), levels);
  }
  if (potential && c.models != Models::membrane) text += atoms_plan(c, potential->potential, levels, launch.cores);
  return text;
}

}  // namespace validate
