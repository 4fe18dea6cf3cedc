// What one model after another says of E·h and pretension, and what the pretension that Eq. 16 reads is made of.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/documents/texts/text_table.hpp"
#include "compare/results/result.hpp"

namespace validate {

/// A model's name for readers: "Eq. 16", "membrane itself", "third-order law", "the potential's own sheet".
std::string model_in_words(const std::string& model);

/// Differences of what Eq. 16 reads from a load's curves, eV/Å²: each has one piece of physics more than the one
/// before.
struct PretensionParts {
  double form = 0;       ///< read from the plain membrane beyond its own pretension: the tip, and the form itself
  double softening = 0;  ///< by the potential's own law
  double bending = 0;
  double rest = 0;   ///< of the atoms
  double total = 0;  ///< read from the atoms, beyond the pretension imposed
};

/// Nothing where a curve of the four is missing or has no fit.
std::optional<PretensionParts> pretension_parts(const Result& result, LoadKind load);

/// Those parts as a sentence.
std::string in_words(const PretensionParts& parts, LoadKind load);

/// The ladder of every fitted curve as a table of text.
std::string ladder_text(const Result& result, int width = widest_line);

/// What is to be said of it, a sentence each.
std::vector<std::string> ladder_sentences(const Result& result);

/// Table and sentences for a page.
std::string ladder_html(const Result& result);

}  // namespace validate
