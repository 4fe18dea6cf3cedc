#include "compare/documents/texts/breaking_text.hpp"

#include <fmt/format.h>

namespace validate {

std::vector<std::string> breaking_sentences(const Result& result) {
  std::vector<std::string> sentences;
  for (const Run& run : result.runs) {
    if (!run.is_atomistic() || !run.atoms().breaking) continue;
    const Breaking& at = *run.atoms().breaking;
    std::string text =
        fmt::format("{} load: the atoms break at {:.2f} … {:.2f} eV/Å, between {:.2f} and {:.2f} Å",
                    to_string(run.load), at.bracket[0], at.bracket[1], at.depth_bracket_A[0], at.depth_bracket_A[1]);
    if (at.past_artefact)
      text += ", in the artefact zone: the force is the cut-off's";
    else if (at.sheet_force_eV_per_A && at.sheet_depth_A)
      text += fmt::format("; the potential's own sheet tears at {:.2f} eV/Å and {:.2f} Å ({:.3f} of the force)",
                          *at.sheet_force_eV_per_A, *at.sheet_depth_A, *at.sheet_force_eV_per_A / at.force_eV_per_A);
    sentences.push_back(text + ".");
  }
  return sentences;
}

}  // namespace validate
