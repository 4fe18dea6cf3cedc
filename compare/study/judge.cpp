#include "compare/study/judge.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "compare/fitting/run_fit.hpp"
#include "compare/results/sheet_columns.hpp"
#include "compare/study/breaking.hpp"
#include "compare/study/cross_section.hpp"
#include "compare/study/uncertainty.hpp"
#include "compare/verdict/agreement.hpp"

namespace validate {
namespace {

std::optional<Explanation> explanation_of(const PairedLoad& load, const std::map<LoadKind, Anisotropy>& anisotropies) {
  const auto* nominal = load.find(Purpose::nominal_radii);
  const auto* paired = load.find(Purpose::paired_radii);
  const auto* bent = load.find(Purpose::bending);
  const auto* sheet = load.find(Purpose::calibrated_sheet);
  if (!load.atoms || !nominal || !paired || !bent || !sheet) return std::nullopt;
  const auto anisotropy = anisotropies.find(load.load);
  return explain(load.atoms->run, {&nominal->run, &paired->run, &bent->run, &sheet->run},
                 anisotropy == anisotropies.end() ? Anisotropy() : anisotropy->second);
}

/// Under a pressure the membrane's cross-section stands beside the atoms'.
void cut(Run& run) {
  if (run.load != LoadKind::pressure || run.is_atomistic() || !run.continuum().pictures) return;
  if (!run.continuum().pictures->empty()) run.cross_section = cross_section(run.continuum().pictures->back());
}

void hand_over(std::vector<PairedLoad>& loads, std::initializer_list<Purpose> purposes, std::vector<Run>& runs) {
  for (PairedLoad& load : loads)
    for (ContinuumExperiment& e : load.continua)
      if (std::ranges::find(purposes, e.purpose) != purposes.end()) {
        cut(e.run);
        runs.push_back(std::move(e.run));
      }
}

/// A calibrated law may lose its stability before the atoms do: that ends its curve, and is no failure.
const Run* gave_up(const Result& result) {
  const auto found = std::ranges::find_if(result.runs, [](const Run& run) {
    return run.ended == Ended::not_converged && run.constants != Constants::calibrated;
  });
  return found == result.runs.end() ? nullptr : &*found;
}

}  // namespace

void judge_all(std::vector<PairedLoad>& loads, const std::map<LoadKind, Anisotropy>& anisotropies,
               const LadderPhysics& ladder, StudyOutcome& outcome) {
  Result& result = outcome.result;
  for (const PairedLoad& load : loads)
    if (auto explanation = explanation_of(load, anisotropies)) result.explanations.push_back(std::move(*explanation));
  for (PairedLoad& load : loads)
    if (load.atoms) result.runs.push_back(std::move(load.atoms->run));
  hand_over(loads, {Purpose::given, Purpose::like_for_like, Purpose::compression_borne, Purpose::paper}, result.runs);
  hand_over(loads, {Purpose::calibrated_membrane, Purpose::calibrated_sheet}, result.runs);
  fit_runs(result, ladder);
  add_biases(result);
  judge(result);
  compare_breaking(result);
  for (const PairedLoad& load : loads)
    if (load.load == result.resolved.judged_load) add_uncertainties(result, load);
  compare_curves(result);
}

void settle_exit(StudyOutcome& outcome) {
  Result& result = outcome.result;
  const auto end = [&](ExitCode code, const std::string& reason) {
    result.exit_code = static_cast<int>(code);
    result.exit_reason = reason;
  };
  if (!outcome.failure.empty()) return end(outcome.failure_code, outcome.failure);
  if (const Run* run = gave_up(result))
    return end(ExitCode::not_converged, fmt::format("{} run of the {} load: {}", to_string(run->model),
                                                    to_string(run->load), run->ended_reason));
  if (result.agreement && result.agreement->outcome != Outcome::agree)
    end(ExitCode::disagreement,
        fmt::format("the atoms' force differs from the {}'s by up to {:.2g} %, more than {:.2g} %",
                    to_string(result.agreement->against), 100 * result.agreement->max_relative_difference,
                    100 * result.agreement->tolerance));
}

}  // namespace validate
