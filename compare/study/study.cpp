#include "compare/study/study.hpp"

#include <fmt/core.h>

#include <cmath>

#include "compare/base/errors.hpp"
#include "compare/base/interrupt.hpp"
#include "compare/pairing/pairing.hpp"
#include "compare/potential/potential_card.hpp"
#include "compare/process/provenance.hpp"
#include "compare/study/atoms.hpp"
#include "compare/study/continua.hpp"
#include "compare/study/flat_tension.hpp"
#include "compare/study/heating.hpp"
#include "compare/study/judge.hpp"
#include "compare/study/levels.hpp"
#include "compare/study/sheet_heat.hpp"
#include "compare/study/summaries.hpp"

namespace validate {
namespace {

/// The card, from the cache or computed; nothing, and the failure told, where the atomistic program failed.
std::optional<PotentialCard> card_of(const Case& c, const PotentialFile& potential, const StudyOptions& options,
                                     StudyOutcome& outcome, Progress& progress) {
  progress.say(fmt::format("potential card of {}", c.potential));
  try {
    PotentialCard found = potential_card(potential, options.launch, card_cache(), false);
    const atomistic::Card& card = found.card;
    progress.say(fmt::format("card: a0 = {:.5f} Å, E·h = {:.3f} eV/Å², ν = {:.4f}, κ = {:.3f} eV", card.a0_A,
                             card.sheet_modulus_eV_per_A2(), card.nu(), card.bending_modulus_eV()));
    return found;
  } catch (const Error& error) {
    if (error.exit_code() == ExitCode::bad_input) throw bad_input("potential '{}': {}", c.potential, error.what());
    if (error.exit_code() != ExitCode::atomistic_failed) throw;
    outcome.failure = std::string("the potential card: ") + error.what();
    outcome.result.agreement_skipped = "there is no potential card";
    return std::nullopt;
  }
}

/// What the atoms' curves are read with beside Eq. 16 and the membrane.
LadderPhysics ladder_of(const PotentialCard* card, const Result& result) {
  if (!card || !card->law) return {};
  const membrane::CauchyBorn& law = card->law->law;
  return {third_order_physics(law.nu, third_order_modulus(law), 0),
          calibrated_physics(law, card->card.bending_modulus_eV(), card->potential.potential.name,
                             result.sheet ? result.sheet->slope_margin_A : 0)};
}

/// Solves every curve: the continua in a thread of their own beside the atoms, which are other processes.
void solve(std::vector<PairedLoad>& loads, const PotentialCard* card, const WarmPotential* warm,
           const StudyOptions& options, StudyOutcome& outcome, Progress& progress) {
  Continua continua(loads, card && card->law ? &*card->law : nullptr, options.all_fields);
  if (outcome.sheet) compute_atoms(loads, *outcome.sheet, options, outcome, progress);
  outcome.result.timing.membrane_s = continua.join();
  if (interrupted()) throw Error(ExitCode::interrupted, "interrupted");
  if (warm)
    for (PairedLoad& load : loads) heat_sheet(load, *card, *warm, heat_of(outcome.result.resolved));
  judge_all(loads, continua.anisotropies(), ladder_of(card, outcome.result), outcome);
}

/// The flat sheet at the case's temperature.
std::optional<WarmPotential> warm_up(const Case& c, const PotentialCard& card, const StudyOptions& options,
                                     StudyOutcome& outcome, Progress& progress) {
  if (!c.temperature_K) return std::nullopt;
  progress.say(fmt::format("the flat sheet at {:g} K", *c.temperature_K));
  WarmPotential warm = warm_potential(card, heat_of(c), warm_strains(card), options.launch);
  outcome.result.warm = {summary_of(warm.card, card.card)};
  if (c.rim == Rim::thermal && !std::isfinite(warm.card.lattice_constant_A))
    throw bad_input(
        "rim: at {} K the flat sheet of '{}' has no lattice constant, its vibrations are unstable; use static",
        *c.temperature_K, c.potential);
  return warm;
}

void run_with_potential(const Case& c, const PotentialFile& potential, const StudyOptions& options,
                        StudyOutcome& outcome, Progress& progress) {
  outcome.result.provenance.potential_file = potential.potential.file;
  outcome.result.provenance.potential_sha256 = potential.sha256;
  outcome.result.provenance.potential_edit = potential.edit;
  const std::optional<PotentialCard> card = card_of(c, potential, options, outcome, progress);
  if (!card) return;
  summarise(*card, outcome.result);
  const std::optional<WarmPotential> warm = warm_up(c, *card, options, outcome, progress);
  const PairedSheet sheet(c, potential.potential, card->card);
  if (c.models != Models::membrane) {
    outcome.potential = potential.potential;
    outcome.sheet = sheet.sheet();
    outcome.result.sheet = summary_of(c, sheet);
  }
  std::vector<PairedLoad> loads = pair(c, {potential, *card, sheet});
  if (has_pulled_rim(c) && outcome.sheet && !measure_flat_tension(loads, *card, options, outcome, progress)) return;
  for (PairedLoad& load : loads) set_levels(c, load);
  solve(loads, &*card, warm ? &*warm : nullptr, options, outcome, progress);
}

void run_alone(const Case& c, const StudyOptions& options, StudyOutcome& outcome, Progress& progress) {
  std::vector<PairedLoad> loads = pair(c);
  for (PairedLoad& load : loads) set_levels(c, load);
  solve(loads, nullptr, nullptr, options, outcome, progress);
}

}  // namespace

StudyOutcome run_study(Command command, const Case& c, const std::optional<PotentialFile>& potential,
                       const StudyOptions& options, Progress& progress) {
  const double start = seconds();
  StudyOutcome outcome;
  outcome.result.command = command;
  outcome.result.resolved = c;
  outcome.result.provenance = provenance(command_line());
  if (potential)
    run_with_potential(c, *potential, options, outcome, progress);
  else
    run_alone(c, options, outcome, progress);
  settle_exit(outcome);
  outcome.result.timing.wall_s = seconds() - start;
  return outcome;
}

}  // namespace validate
