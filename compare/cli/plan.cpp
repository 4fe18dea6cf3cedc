#include "compare/cli/plan.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "atomistic/protocol/preconditioning.hpp"
#include "compare/base/memory.hpp"
#include "compare/documents/texts/json.hpp"
#include "compare/process/atoms_budget.hpp"
#include "membrane/problem.hpp"

namespace validate {
namespace {

std::string memory_line(const Case& c, const AtomsBudget& budget, const AtomsLaunch& launch) {
  const int curves = static_cast<int>(c.loads.size());
  const auto there = available_memory_bytes();
  const std::string free = there ? fmt::format(", {:.1f} GB are free", 1e-9 * *there) : "";
  const int at_once = curves_at_once(budget, launch, curves);
  return fmt::format("memory: about {:.1f} GB a curve{}{}\n", 1e-9 * budget.memory_bytes, free,
                     at_once < curves ? fmt::format(": {} of {} curves at a time", at_once, curves) : "");
}

std::string atoms_plan(const Case& c, const atomistic::Potential& potential, std::size_t levels,
                       const AtomsLaunch& launch) {
  const AtomsBudget budget = atoms_budget(c, potential, levels);
  const double curves = static_cast<double>(c.loads.size());
  const bool multigrid = budget.preconditioning == atomistic::Preconditioning::multigrid;
  return fmt::format(
      "atoms: about {:.0f} ({:.1f} Å wide clamped ring), {:.0f} curve(s) of {} depths or more\n"
      "preconditioner: {}{}\n"
      "{}estimate: about {:.0f} s on {} core(s); one curve on one core: start {:.1f} s, forces {:.1f} s, {} {:.1f} s, "
      "{} "
      "{:.1f} s\n",
      budget.atoms, potential.interaction_range_A, curves, levels, multigrid ? "multigrid" : "factor",
      atomistic::has_multigrid() ? "" : " (built without hypre: there is no multigrid)", memory_line(c, budget, launch),
      3 + curves * budget.all_s() / std::min<double>(launch.cores, curves), launch.cores, budget.start_s,
      budget.forces_s, multigrid ? "set-ups" : "factorisations", budget.set_ups_s, multigrid ? "cycles" : "solves",
      budget.solves_s);
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
  if (potential && c.models != Models::membrane) text += atoms_plan(c, potential->potential, levels, launch);
  return text;
}

}  // namespace validate
