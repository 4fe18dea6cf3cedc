#include "compare/study/breaking.hpp"

#include <algorithm>
#include <iterator>

namespace validate {
namespace {

using atomistic::Step;

std::vector<const Step*> borne(const std::vector<Step>& steps) {
  std::vector<const Step*> found;
  for (const Step* step : steps_of_curve(steps))
    if (step->converged && !step->broken) found.push_back(step);
  return found;
}

/// The break that is nearest to what was borne.
const Step* first_broken(const std::vector<Step>& steps) {
  const Step* first = nullptr;
  for (const Step& step : steps)
    if (step.broken && (!first || step.target < first->target)) first = &step;
  return first;
}

/// A straight line through the last two states, or the origin and the only one, at the level that broke.
double continued(const std::vector<const Step*>& borne, double target, double Step::*value) {
  const Step origin;
  const Step& last = *borne.back();
  const Step& before = borne.size() > 1 ? *borne[borne.size() - 2] : origin;
  const double share = (target - last.target) / (last.target - before.target);
  return last.*value + share * (last.*value - before.*value);
}

const Run* torn_sheet(const Result& result, LoadKind load) {
  const auto found = std::ranges::find_if(result.runs, [&](const Run& run) {
    return run.model == Model::sheet && run.constants == Constants::calibrated && run.load == load &&
           run.ended == Ended::rupture;
  });
  return found == result.runs.end() ? nullptr : &*found;
}

}  // namespace

std::vector<const Step*> steps_of_curve(const std::vector<Step>& steps) {
  std::vector<const Step*> curve, tries;
  for (const Step& step : steps) {
    if (step.unloading) continue;
    if (!step.search)
      curve.push_back(&step);
    else if (step.converged && !step.broken)
      tries.push_back(&step);
  }
  std::ranges::sort(tries, {}, &Step::target);
  const auto broken = std::ranges::find_if(curve, [](const Step* step) { return step->broken; });
  curve.insert(broken, tries.begin(), tries.end());
  return curve;
}

std::optional<Breaking> breaking_of(const std::vector<Step>& steps, double artefact_bond_A) {
  const std::vector<const Step*> states = borne(steps);
  const Step* const broken = first_broken(steps);
  if (!broken || states.empty() || !(broken->target > states.back()->target)) return std::nullopt;
  const Step& last = *states.back();
  const auto strongest = std::ranges::max_element(states, {}, [](const Step* s) { return s->force_eV_per_A; });
  Breaking found;
  found.force_eV_per_A = (*strongest)->force_eV_per_A;
  found.depth_A = last.depth_A;
  found.bracket = {found.force_eV_per_A,
                   std::max(found.force_eV_per_A, continued(states, broken->target, &Step::force_eV_per_A))};
  found.depth_bracket_A = {last.depth_A, continued(states, broken->target, &Step::depth_A)};
  found.past_artefact = last.longest_bond_A >= artefact_bond_A;
  return found;
}

void compare_breaking(Result& result) {
  for (Run& run : result.runs) {
    if (!run.is_atomistic() || !run.atoms().breaking) continue;
    Breaking& breaking = *run.atoms().breaking;
    if (const Run* sheet = torn_sheet(result, run.load); sheet && !sheet->depth_A.empty()) {
      breaking.sheet_force_eV_per_A = std::ranges::max(sheet->force_eV_per_A);
      breaking.sheet_depth_A = sheet->depth_A.back();
    }
    if (result.agreement && result.agreement->load == run.load) result.agreement->breaking = breaking;
  }
}

}  // namespace validate
