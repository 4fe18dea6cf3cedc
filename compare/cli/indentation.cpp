#include "compare/cli/indentation.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <string_view>

#include "compare/base/paths.hpp"
#include "compare/cli/batch.hpp"
#include "compare/cli/flags.hpp"
#include "compare/cli/run_indentation.hpp"
#include "compare/input/case_file.hpp"
#include "compare/input/potential_file.hpp"
#include "compare/potential/switch_length.hpp"

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

struct ReadCase {
  Case c;
  std::optional<PotentialFile> potential;
};

ReadCase read(const CaseFlags& flags, const RunOptions& options, const Variant& variant) {
  ReadCase result;
  Case& c = result.c;
  Origins origins = options.case_file ? read_case(*options.case_file, c, "--case")
                                      : read_case(inputs_folder() / "indentation.toml", c);
  flags.apply(c, origins, variant);
  for (const std::string& warning : check(c, origins)) spdlog::warn("{}", warning);
  if (!has_given_constants(c)) {
    result.potential = read_potential(c.potential, inputs_folder() / "potentials", label_of(origins, "potential"));
    for (const std::string& warning : result.potential->warnings) spdlog::warn("{}", warning);
    if (c.switch_length_A) check_switch(*result.potential, label_of(origins, "switch-length"));
  }
  return result;
}

/// Flags that a case of a batch gets from the batch itself.
bool is_batch_flag(const std::string& name) {
  constexpr std::string_view own[] = {"--help",      "--potential", "--radius",  "--out",  "--json",
                                      "--overwrite", "--resume",    "--dry-run", "--quiet"};
  return std::find(std::begin(own), std::end(own), name) != std::end(own);
}

/// The flags given, as words for another start of this program.
std::vector<std::string> common_words(const CLI::App& command) {
  std::vector<std::string> words;
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    if (option->count() == 0 || is_batch_flag(name)) continue;
    words.push_back(name);
    if (option->get_items_expected_max() > 0) words.push_back(fmt::format("{}", fmt::join(option->results(), ",")));
  }
  return words;
}

/// The variant's text, or the one that all cases share.
void add_word(std::vector<std::string>& words, const CLI::App& command, const char* flag,
              const std::optional<std::string>& text) {
  const CLI::Option& option = *command.get_option(flag);
  if (option.count() > 0) words.insert(words.end(), {flag, text ? *text : option.results().front()});
}

int indentation(const CLI::App& command, const CaseFlags& flags, const RunOptions& options) {
  check(options);
  const std::vector<Variant> variants = flags.variants();
  if (variants.size() == 1) {
    const ReadCase one = read(flags, options, variants.front());
    return run_indentation(one.c, options, one.potential);
  }
  std::vector<BatchCase> cases;
  for (const Variant& variant : variants) {  // every case is checked before the first one starts
    const ReadCase one = read(flags, options, variant);
    BatchCase entry{one.c.potential, one.c.radius_A, {}};
    add_word(entry.words, command, "--potential", variant.potential);
    add_word(entry.words, command, "--radius", variant.radius);
    cases.push_back(std::move(entry));
  }
  return run_batch(cases, common_words(command), options);
}

}  // namespace

void add_indentation(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("indentation", "wrinkling membrane against atoms under an indenter");
  const auto flags = std::make_shared<const CaseFlags>(*command);
  const auto options = std::make_shared<RunOptions>();
  add_run_options(*command, *options);
  command
      ->add_flag("--all-fields", options->all_fields,
                 "fields of the membranes (ParaView, run.h5) at every depth, not at the last only: 2 MB a "
                 "depth and curve")
      ->group("Run");
  command->footer(indentation_examples);
  command->callback([command, flags, options, &exit_code] { exit_code = indentation(*command, *flags, *options); });
}

}  // namespace validate
