// The verdict in a sentence that can be quoted.
#pragma once

#include <string>

#include "compare/results/result.hpp"

namespace validate {

/// "AGREEMENT", "DISAGREEMENT", "UNDECIDED".
const char* outcome_word(Outcome);

/// Over what range the atoms' force differs from the continuum's, by how much at most and where, how uncertain that is
/// and what passes; of an undecided verdict what is to be known better.
std::string verdict_sentence(const Agreement&, const Case&);

/// "UNDECIDED: at most 0.49 % apart, known to ± 1.16 % (95 %); tolerance 1.00 %."
std::string short_verdict(const Agreement&);

}  // namespace validate
