#include "compare/documents/texts/table.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <utility>

#include "compare/base/errors.hpp"
#include "compare/base/standard_streams.hpp"
#include "compare/base/terminal.hpp"
#include "compare/documents/sentences/shown_units.hpp"
#include "compare/documents/sentences/verdict_text.hpp"
#include "compare/documents/texts/breaking_text.hpp"
#include "compare/documents/texts/explanation_text.hpp"
#include "compare/documents/texts/ladder.hpp"
#include "compare/documents/texts/numbers.hpp"
#include "compare/documents/texts/pressed_table.hpp"
#include "compare/documents/texts/pulled_rim_table.hpp"
#include "compare/documents/texts/regime_text.hpp"
#include "compare/documents/texts/thermal_text.hpp"

namespace validate {

namespace {

/// Adds a sentence; it is broken into lines at the end.
template <class... Parts>
void sentence(std::string& text, fmt::format_string<Parts...> format, Parts&&... parts) {
  text += fmt::format(format, std::forward<Parts>(parts)...) + '\n';
}

std::string name_of(const Run& run) {
  const std::string name = fmt::format("{} {}", to_string(run.model), to_string(run.load));
  return run.constants ? fmt::format("{} {}", name, to_string(*run.constants)) : name;
}

// How far each curve goes, artefact zone included.
void add_ends(std::string& text, const std::vector<Run>& runs, const ShownUnits& shown, int width) {
  TextTable ends({{.heading = "How far each curve goes", .align = Align::left},
                  {.heading = "force", .unit = shown.force.name},
                  {.heading = "depth", .unit = shown.length.name},
                  {.heading = "ended by", .align = Align::left}});
  for (const Run& run : runs) {
    std::string force = "-", depth = "-";
    for (std::size_t i = 0; i < run.depth_A.size(); ++i)
      if (run.converged[i])
        force = fmt::format("{:.4g}", shown.force.of(run.force_eV_per_A[i])),
        depth = fmt::format("{:.4g}", shown.length.of(run.depth_A[i]));
    ends.add({name_of(run), force, depth, std::string(to_string(run.ended))});
  }
  text += ends.text(width) + '\n';
}

void add_notes(std::string& text, const Result& result, const Run& run) {
  const Fit* fit = closed_form_fit(run.fits);
  const auto artefacts = run.is_atomistic() ? std::ranges::count(run.atoms().artefact, true) : 0;
  if (artefacts > 0) {
    sentence(text, "{}: {} {} with a bond ≥ {:.2f} Å (artefact zone, from {} on) left out of fit and verdict",
             name_of(run), artefacts, artefacts == 1 ? "point" : "points", artefact_bond_of(result),
             shown_units(result.resolved).length.text(run.depth_A[*first_artefact(run)]));
  }
  if (run.is_atomistic() && run.atoms().contact) {
    const ContactSensitivity* c = &*run.atoms().contact;
    sentence(
        text,
        "{}: atoms up to {:.3f} Å inside the sphere; a contact four times stiffer changes the last force by {:.2f} % "
        "at equal travel, {:.2f} % at equal depth",
        name_of(run), c->deepest_penetration_A, 100 * c->force_change_relative,
        100 * c->force_change_at_equal_depth_relative);
  }
  if (!fit) sentence(text, "{}: no fit: {}", name_of(run), run.fit_skipped);
  for (const std::string& skipped : run.models_skipped) sentence(text, "{}: not fitted: {}", name_of(run), skipped);
  const bool as_laws_do = run.ended == Ended::calibration_end;
  if (!run.ended_reason.empty() && run.ended != Ended::depth_max && !as_laws_do) {
    sentence(text, "{}: path ended ({}): {}", name_of(run), to_string(run.ended), run.ended_reason);
  }
  if (!fit || (run.constants && run.constants != Constants::given)) return;
  for (const Fit& one : run.fits)
    for (const std::string& warning : one.warnings)
      if (one.recommended || &one == fit)
        sentence(text, "{}, {}: {}", name_of(run), model_in_words(one.model), warning);
}

// Where the atoms follow the membrane, and why not elsewhere.
void add_regimes(std::string& text, const Result& result) {
  for (const Comparison& c : result.comparisons) {
    if (c.depth_A.empty() || c.load == LoadKind::pressure) continue;
    std::string more;
    if (std::isfinite(c.predicted_artefact_from_A))
      more = fmt::format("; the sheet's strains put the artefact zone's beginning at {}",
                         shown_units(result.resolved).length.text(c.predicted_artefact_from_A));
    sentence(text, "{} load: {}{}", to_string(c.load), regime_text(c), more);
  }
  if (!result.comparisons.empty()) text += '\n';
}

void add_verdict(std::string& text, const Result& result, bool colour) {
  if (!result.agreement) {
    sentence(text, "No verdict: {}.",
             result.agreement_skipped.empty() ? "nothing to compare" : result.agreement_skipped);
    return;
  }
  const Agreement& agreement = *result.agreement;
  const char* colours[] = {"\033[1;32m", "\033[1;31m", "\033[1;33m"};  // by outcome
  if (colour) text += colours[static_cast<std::size_t>(agreement.outcome)];
  text += outcome_word(agreement.outcome);
  if (colour) text += "\033[0m";
  text += '\n';
  sentence(text, "{}", verdict_sentence(agreement, result.resolved));
}

void add_fits(std::string& text, const Result& result, const std::vector<Run>& runs, int width) {
  text += ladder_text(result, width);
  for (const std::string& one : ladder_sentences(result)) sentence(text, "{}", one);
  text += '\n';
  add_ends(text, runs, shown_units(result.resolved), width);
  const std::size_t before_notes = text.size();
  for (const Run& run : runs) add_notes(text, result, run);
  if (text.size() > before_notes) text += '\n';
}

/// Paths that did not come to their end, of sheets that have no row elsewhere.
std::string ended_early(const Result& result) {
  std::string text;
  for (const Run& run : result.runs)
    if (run.ended != Ended::depth_max)
      sentence(text, "{}: path ended ({}): {}", name_of(run), to_string(run.ended), run.ended_reason);
  return text.empty() ? text : "\n" + text;
}

/// The potential, the sheet and the membrane's law that all rests on.
void add_given(std::string& text, const Result& result) {
  if (const auto& card = result.card)
    sentence(text, "{}: a0 = {:.4f} Å, E·h = {:.1f} N/m ({:.2f} eV/Å²), nu = {:.4f}", result.resolved.potential,
             card->a0_A, in_N_per_m(card->Eh_eV_per_A2), card->Eh_eV_per_A2, card->nu);
  if (const auto& sheet = result.sheet)
    sentence(text, "sheet: R = {:g} Å, effective radius a = {:.3f} Å, {} atoms", sheet->radius_A,
             sheet->effective_radius_A, sheet->atoms);
  if (result.resolved.law.is_chosen()) sentence(text, "law of the membrane: {}", in_words(result.resolved.law));
  if (result.card || result.sheet || result.resolved.law.is_chosen()) text += '\n';
}

std::string whole_table(const Result& result, int width, bool colour) {
  std::vector<Run> indented;
  std::ranges::copy_if(result.runs, std::back_inserter(indented),
                       [](const Run& run) { return run.load != LoadKind::pressure; });
  const std::string pressed = pressed_table(result, width), pulled = pulled_rim_table(result, width);
  std::string text;
  if (!pulled.empty()) {
    if (result.sheet) add_verdict(text, result, colour);
    if (result.sheet) text += '\n';
    add_given(text, result);
    return text + pulled + ended_early(result);
  }
  if (indented.empty()) {
    add_given(text, result);
    return text + pressed + ended_early(result);
  }
  add_verdict(text, result, colour);
  text += '\n';
  add_given(text, result);
  if (!pressed.empty()) text += pressed + '\n';
  add_fits(text, result, indented, width);
  text += explanation_text(result, width);
  add_regimes(text, result);
  for (const std::string& one : breaking_sentences(result)) sentence(text, "{}", one);
  text += thermal_table(result);
  for (const std::string& one : thermal_sentences(result)) sentence(text, "{}", one);
  return text;
}

}  // namespace

std::string table(const Result& result, int width, bool colour) {
  return wrapped(whole_table(result, width, colour), std::min(width, widest_line));
}

void print_table(const Result& result) {
  const char* const no_color = std::getenv("NO_COLOR");
  print_result(table(result, line_width(), ::isatty(STDOUT_FILENO) && (!no_color || !*no_color)));
}

}  // namespace validate
