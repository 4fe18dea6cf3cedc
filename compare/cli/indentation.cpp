#include "compare/cli/indentation.hpp"

#include "compare/cli/experiment.hpp"

namespace validate {

namespace {

constexpr const char* indentation_examples =
    R"(Values may carry a unit ("11 nm", "0.34 N/m", "1.0209 TPa"); without one they are in the unit shown.
Flags win over the case file.

Examples:
  validate indentation --radius 110
  validate indentation --potential tersoff --radius 60 --loads disc --out runs/tersoff
  validate indentation --potential tersoff --loads sphere --judged-load sphere --tip-radius 27.5
  validate indentation --potential airebo,rebo,tersoff,lcbop --radius 60,110   # a batch, one folder per case
  validate indentation --models membrane --radius "0.5 um" --E "1.0209 TPa" --thickness "0.335 nm" --nu 0.165 \
      --pretension "0.34 N/m" --loads disc --tip-radius "1 nm" --depth-step "5 nm")";

}  // namespace

void add_indentation(CLI::App& app, int& exit_code) {
  add_experiment(app,
                 {.name = Command::indentation,
                  .description = "wrinkling membrane against atoms under an indenter",
                  .defaults = Case(),
                  .case_file = "indentation.toml",
                  .examples = indentation_examples},
                 exit_code);
}

}  // namespace validate
