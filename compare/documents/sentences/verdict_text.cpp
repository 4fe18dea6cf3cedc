#include "compare/documents/sentences/verdict_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/documents/sentences/shown_units.hpp"

namespace validate {
namespace {

/// The judged point that differs most.
std::string worst_point(const Agreement& agreement, const ShownUnits& shown) {
  if (agreement.ratios.empty()) return "";
  const auto difference = [](const JudgedRatio& judged) { return std::abs(judged.ratio - 1); };
  const JudgedRatio& worst = *std::ranges::max_element(agreement.ratios, {}, difference);
  return fmt::format(" (at {}: atoms / {} = {:.4f})", shown.length.text(worst.depth_A), to_string(agreement.against),
                     worst.ratio);
}

/// "clamp_radius" as words.
std::string source_in_words(std::string source) {
  std::ranges::replace(source, '_', ' ');
  return source;
}

const char* continuum_in_words(const Agreement& agreement) {
  return agreement.against == Model::sheet ? "the potential's own law, with bending" : "card constants";
}

}  // namespace

const char* outcome_word(Outcome outcome) {
  switch (outcome) {
    case Outcome::agree:
      return "AGREEMENT";
    case Outcome::disagree:
      return "DISAGREEMENT";
    case Outcome::undecided:
      break;
  }
  return "UNDECIDED";
}

std::string verdict_sentence(const Agreement& agreement, const Case& c) {
  const std::string dominant = source_in_words(agreement.dominant);
  std::string text = fmt::format(
      "Over depth/a from {:.2f} to {:.2f} of the {} load the atoms' force differs from the {}'s ({}) "
      "by at most {:.2f} %{}; the ratios are uncertain by up to ± {:.2f} % (95 %{}); the tolerance is {:.2f} %.",
      agreement.window[0], agreement.window[1], to_string(agreement.load), to_string(agreement.against),
      continuum_in_words(agreement), 100 * agreement.max_relative_difference, worst_point(agreement, shown_units(c)),
      100 * agreement.expanded_uncertainty, dominant.empty() ? std::string() : ", mostly the " + dominant,
      100 * agreement.tolerance);
  if (agreement.outcome == Outcome::undecided)
    text += fmt::format(" Neither agreement nor disagreement within the tolerance is shown: {} is what to know better.",
                        dominant.empty() ? std::string("nothing") : "the " + dominant);
  return text;
}

std::string short_verdict(const Agreement& agreement) {
  return fmt::format("{}: at most {:.2f} % apart, known to ± {:.2f} % (95 %); tolerance {:.2f} %.",
                     outcome_word(agreement.outcome), 100 * agreement.max_relative_difference,
                     100 * agreement.expanded_uncertainty, 100 * agreement.tolerance);
}

}  // namespace validate
