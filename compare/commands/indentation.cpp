#include "compare/commands/indentation.hpp"

#include <spdlog/spdlog.h>

#include <memory>
#include <optional>

#include "compare/case_file.hpp"
#include "compare/commands/flags.hpp"
#include "compare/commands/run_indentation.hpp"
#include "compare/paths.hpp"
#include "compare/potential_file.hpp"

namespace compare {
namespace {

constexpr const char* examples =
    R"(Values may carry a unit ("11 nm", "0.34 N/m", "1.0209 TPa"); without one they are in the unit shown.
Flags win over the case file.

Examples:
  validate indentation --radius 110
  validate indentation --potential tersoff --radius 60 --loads disc --out runs/tersoff
  validate indentation --models membrane --radius "0.5 um" --E "1.0209 TPa" --thickness "0.335 nm" --nu 0.165 \
      --pretension "0.34 N/m" --loads disc --tip-radius "1 nm" --depth-step "5 nm")";

int indentation(const CaseFlags& flags, const RunOptions& options) {
  check(options);
  Case c;
  Origins origins = options.case_file ? read_case(*options.case_file, c, "--case")
                                      : read_case(inputs_folder() / "indentation.toml", c);
  flags.apply(c, origins);
  for (const std::string& warning : check(c, origins)) spdlog::warn("{}", warning);

  std::optional<PotentialFile> potential;
  if (!has_given_constants(c)) {
    potential = read_potential(c.potential, inputs_folder() / "potentials", label_of(origins, "potential"));
  }
  return run_indentation(c, options, potential);
}

}  // namespace

void add_indentation(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("indentation", "wrinkling membrane against atoms under an indenter");
  const auto flags = std::make_shared<const CaseFlags>(*command);
  const auto options = std::make_shared<RunOptions>();
  add_run_options(*command, *options);
  command->footer(examples);
  command->callback([flags, options, &exit_code] { exit_code = indentation(*flags, *options); });
}

}  // namespace compare
