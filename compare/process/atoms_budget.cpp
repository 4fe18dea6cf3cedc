#include "compare/process/atoms_budget.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "atomistic/protocol/preconditioning.hpp"
#include "compare/base/errors.hpp"
#include "compare/base/memory.hpp"

namespace validate {
namespace {

using atomistic::Preconditioning;

/// Graphene's lattice constant, for counting before the potential's own is known.
constexpr double typical_a0_A = 2.46;

// Measured, one core: averages over the levels of a path. Seconds are those for an atom, or for 1e5 atoms where they
// grow faster than the atoms.
constexpr double evaluations_per_level = 7;
constexpr double set_ups_per_level = 0.55;  // a factor or a hierarchy serves two levels or one
constexpr double start_s = 1.0e-5;
constexpr double factor_s = 2.0, factor_growth = 1.5, factor_solve_s = 6.5e-7;
constexpr double multigrid_s = 1.25e-5, cycle_s = 3.0e-6;
constexpr double process_bytes = 5e7;
constexpr double factor_bytes = 1.0e4, factor_bytes_growth = 1.06, multigrid_bytes = 4.8e3;
constexpr double memory_kept_free = 0.95;  // of what is there

struct ForceTime {
  std::string_view style;
  double seconds;  ///< of an atom's force
};

/// A style that is not here is taken for the dearest.
constexpr ForceTime force_times[] = {{"tersoff", 8e-7}, {"rebo", 2.3e-6}, {"lcbop", 2.5e-6}, {"airebo", 5e-6}};

double force_s(const atomistic::Potential& potential) {
  const std::string style = potential.pair_style.substr(0, potential.pair_style.find(' '));
  double dearest = 0;
  for (const ForceTime& known : force_times) {
    if (known.style == style) return known.seconds;
    dearest = std::max(dearest, known.seconds);
  }
  return dearest;
}

Preconditioning asked(const Case& c) {
  switch (c.preconditioner) {
    case Preconditioner::factor:
      return Preconditioning::factor;
    case Preconditioner::multigrid:
      return Preconditioning::multigrid;
    case Preconditioner::automatic:
      break;
  }
  return Preconditioning::automatic;
}

double area_A2(const Case& c, double outer_A) {
  return c.shape == Shape::disc ? std::numbers::pi * outer_A * outer_A : 4 * outer_A * outer_A;
}

double memory_bytes(Preconditioning kind, double atoms) {
  constexpr double reference = 1e5;
  if (kind == Preconditioning::multigrid) return process_bytes + multigrid_bytes * atoms;
  return process_bytes + factor_bytes * reference * std::pow(atoms / reference, factor_bytes_growth);
}

}  // namespace

AtomsBudget atoms_budget(const Case& c, const atomistic::Potential& potential, std::size_t levels) {
  constexpr double reference = 1e5, atom_area_A2 = std::numbers::sqrt3 / 4 * typical_a0_A * typical_a0_A;
  const double ring_A = c.edge == Edge::clamped ? potential.interaction_range_A : 0;
  const double free_atoms = area_A2(c, c.radius_A) / atom_area_A2;
  AtomsBudget budget;
  budget.atoms = area_A2(c, c.radius_A + ring_A) / atom_area_A2;
  budget.preconditioning = atomistic::preconditioning_for(asked(c), static_cast<int>(std::min(free_atoms, 1e9)));
  const bool multigrid = budget.preconditioning == Preconditioning::multigrid;
  const double evaluations = evaluations_per_level * static_cast<double>(levels);
  const double set_ups = std::max(1.0, set_ups_per_level * static_cast<double>(levels));
  budget.memory_bytes = memory_bytes(budget.preconditioning, budget.atoms);
  budget.start_s = start_s * budget.atoms;
  budget.forces_s = evaluations * budget.atoms * force_s(potential);
  budget.set_ups_s =
      set_ups * (multigrid ? multigrid_s * free_atoms : factor_s * std::pow(free_atoms / reference, factor_growth));
  // One for each evaluation, and one for the load's own response in each metric.
  budget.solves_s = (evaluations + set_ups) * free_atoms * (multigrid ? cycle_s : factor_solve_s);
  return budget;
}

int curves_at_once(const AtomsBudget& budget, const AtomsLaunch& launch, int curves) {
  const auto there = available_memory_bytes();
  if (!there || !launch.launcher.empty()) return curves;
  return std::clamp(static_cast<int>(memory_kept_free * *there / budget.memory_bytes), 1, std::max(1, curves));
}

void require_memory(const Case& c, const atomistic::Potential& potential, const AtomsLaunch& launch) {
  const auto there = available_memory_bytes();
  const AtomsBudget budget = atoms_budget(c, potential, 1);
  if (!there || !launch.launcher.empty() || budget.memory_bytes <= memory_kept_free * *there) return;
  const double other = memory_bytes(Preconditioning::multigrid, budget.atoms);
  const bool helps = budget.preconditioning == Preconditioning::factor && atomistic::has_multigrid() &&
                     other <= memory_kept_free * *there;
  throw bad_input(
      "the atoms of a radius of {:.6g} Å, about {:.3g} million, need about {:.1f} GB with the {} as preconditioner, "
      "and "
      "{:.1f} GB are free here; {}a smaller --radius, more memory, or several machines by --launcher",
      c.radius_A, 1e-6 * budget.atoms, 1e-9 * budget.memory_bytes,
      budget.preconditioning == Preconditioning::multigrid ? "multigrid" : "factor", 1e-9 * *there,
      helps ? fmt::format("--preconditioner multigrid needs {:.1f} GB; else ", 1e-9 * other) : std::string());
}

}  // namespace validate
