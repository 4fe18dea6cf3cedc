#include "compare/documents/texts/table.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <sstream>
#include <utility>

#include "compare/base/errors.hpp"
#include "compare/base/standard_streams.hpp"
#include "compare/documents/texts/breaking_text.hpp"
#include "compare/documents/texts/explanation_text.hpp"
#include "compare/documents/texts/ladder.hpp"
#include "compare/documents/texts/numbers.hpp"
#include "compare/documents/texts/pressed_table.hpp"
#include "compare/documents/texts/regime_text.hpp"

namespace validate {

namespace {

constexpr int widest_line = 120;

// Characters, not bytes: the continuation bytes of UTF-8 do not count.
int width_of(std::string_view text) {
  return static_cast<int>(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

// Adds a sentence, broken at blanks where it grows too long.
template <class... Parts>
void sentence(std::string& text, fmt::format_string<Parts...> format, Parts&&... parts) {
  std::istringstream words(fmt::format(format, std::forward<Parts>(parts)...));
  int width = 0;
  for (std::string word; words >> word; width += width_of(word)) {
    const bool too_long = width > 0 && width + 1 + width_of(word) > widest_line;
    if (width > 0) text += too_long ? "\n    " : " ";
    width = too_long ? 4 : width + (width > 0);
    text += word;
  }
  text += '\n';
}

std::string name_of(const Run& run) {
  const std::string name = fmt::format("{} {}", to_string(run.model), to_string(run.load));
  return run.constants ? fmt::format("{} {}", name, to_string(*run.constants)) : name;
}

// How far each curve goes, artefact zone included.
void add_ends(std::string& text, const std::vector<Run>& runs) {
  for (const Run& run : runs) {
    std::string last = "-";
    for (std::size_t i = 0; i < run.depth_A.size(); ++i)
      if (run.converged[i]) last = fmt::format("{:.4g} eV/Å at {:.4g} Å", run.force_eV_per_A[i], run.depth_A[i]);
    text += fmt::format("{:<28}{:<26}{}\n", name_of(run), last, to_string(run.ended));
  }
  text += '\n';
}

void add_notes(std::string& text, const Result& result, const Run& run) {
  const Fit* fit = closed_form_fit(run.fits);
  const auto artefacts = run.is_atomistic() ? std::ranges::count(run.atoms().artefact, true) : 0;
  if (artefacts > 0) {
    sentence(text, "{}: {} {} with a bond ≥ {:.2f} Å (artefact zone, from {:.4g} Å on) left out of fit and verdict",
             name_of(run), artefacts, artefacts == 1 ? "point" : "points", artefact_bond_of(result),
             run.depth_A[*first_artefact(run)]);
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

// The judged point that differs most, in words.
std::string worst_point(const Agreement& agreement) {
  if (agreement.ratios.empty()) return "";
  const auto difference = [](const JudgedRatio& judged) { return std::abs(judged.ratio - 1); };
  const JudgedRatio& worst = *std::ranges::max_element(agreement.ratios, {}, difference);
  return fmt::format(" (at {:.4g} Å: atoms / {} = {:.4f})", worst.depth_A, to_string(agreement.against), worst.ratio);
}

// "clamp_radius" as words.
std::string source_in_words(std::string source) {
  std::ranges::replace(source, '_', ' ');
  return source;
}

// Where the atoms follow the membrane, and why not elsewhere.
void add_regimes(std::string& text, const Result& result) {
  for (const Comparison& c : result.comparisons) {
    if (c.depth_A.empty() || c.load == LoadKind::pressure) continue;
    std::string more;
    if (std::isfinite(c.predicted_artefact_from_A))
      more = fmt::format("; the sheet's strains put the artefact zone's beginning at {:.3g} Å",
                         c.predicted_artefact_from_A);
    sentence(text, "{} load: {}{}", to_string(c.load), regime_text(c), more);
  }
  if (!result.comparisons.empty()) text += '\n';
}

const char* constants_of(const Agreement& agreement) {
  return agreement.against == Model::sheet ? "the potential's own law, with bending" : "card constants";
}

void add_verdict(std::string& text, const Result& result, bool colour) {
  if (!result.agreement) {
    sentence(text, "No verdict: {}.",
             result.agreement_skipped.empty() ? "nothing to compare" : result.agreement_skipped);
    return;
  }
  const Agreement& agreement = *result.agreement;
  const char* colours[] = {"\033[1;32m", "\033[1;31m", "\033[1;33m"};  // by outcome
  const char* words[] = {"AGREEMENT", "DISAGREEMENT", "UNDECIDED"};
  const auto outcome = static_cast<std::size_t>(agreement.outcome);
  if (colour) text += colours[outcome];
  text += words[outcome];
  if (colour) text += "\033[0m";
  text += '\n';
  sentence(text,
           "Over depth/a from {:.2f} to {:.2f} of the {} load the atoms' force differs from the {}'s ({}) "
           "by at most {:.2f} %{}; the ratios are uncertain by up to ± {:.2f} % (95 %{}); the tolerance is {:.2f} %.",
           agreement.window[0], agreement.window[1], to_string(agreement.load), to_string(agreement.against),
           constants_of(agreement), 100 * agreement.max_relative_difference, worst_point(agreement),
           100 * agreement.expanded_uncertainty,
           agreement.dominant.empty() ? std::string() : ", mostly the " + source_in_words(agreement.dominant),
           100 * agreement.tolerance);
  if (agreement.outcome == Outcome::undecided)
    sentence(text, "Neither agreement nor disagreement within the tolerance is shown: {} is what to know better.",
             agreement.dominant.empty() ? std::string("nothing") : "the " + source_in_words(agreement.dominant));
}

void add_fits(std::string& text, const Result& result, const std::vector<Run>& runs) {
  text += ladder_text(result);
  for (const std::string& one : ladder_sentences(result)) sentence(text, "{}", one);
  text += '\n';
  add_ends(text, runs);
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

}  // namespace

std::string table(const Result& result, bool colour) {
  std::string text;
  if (const auto& card = result.card) {
    sentence(text, "{}: a0 = {:.4f} Å, E·h = {:.1f} N/m ({:.2f} eV/Å²), nu = {:.4f}", result.resolved.potential,
             card->a0_A, in_N_per_m(card->Eh_eV_per_A2), card->Eh_eV_per_A2, card->nu);
  }
  if (const auto& sheet = result.sheet) {
    sentence(text, "sheet: R = {:g} Å, effective radius a = {:.3f} Å, {} atoms", sheet->radius_A,
             sheet->effective_radius_A, sheet->atoms);
  }
  if (result.resolved.law.is_chosen()) sentence(text, "law of the membrane: {}", in_words(result.resolved.law));
  if (!text.empty()) text += '\n';
  const std::string pressed = pressed_table(result);
  text += pressed;
  std::vector<Run> indented;
  std::ranges::copy_if(result.runs, std::back_inserter(indented),
                       [](const Run& run) { return run.load != LoadKind::pressure; });
  if (indented.empty()) return text + ended_early(result);
  if (!pressed.empty()) text += '\n';
  add_verdict(text, result, colour);
  text += '\n';
  add_fits(text, result, indented);
  text += explanation_text(result);
  add_regimes(text, result);
  for (const std::string& one : breaking_sentences(result)) sentence(text, "{}", one);
  return text;
}

void print_table(const Result& result) {
  const char* const no_color = std::getenv("NO_COLOR");
  print_result(table(result, ::isatty(STDOUT_FILENO) && (!no_color || !*no_color)));
}

}  // namespace validate
