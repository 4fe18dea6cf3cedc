#include "compare/cli/experiment.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <string_view>

#include "compare/base/errors.hpp"
#include "compare/base/paths.hpp"
#include "compare/cli/batch.hpp"
#include "compare/cli/flags.hpp"
#include "compare/cli/run_experiment.hpp"
#include "compare/input/case_file.hpp"
#include "compare/input/potential_file.hpp"
#include "compare/potential/switch_length.hpp"

namespace validate {
namespace {

struct ReadCase {
  Case c;
  std::optional<PotentialFile> potential;
};

/// With a potential a membrane under a pressure takes its constants from the card: those that only a case file gives as
/// the defaults of a membrane alone are not meant then, and one given as a flag would be lost.
void prefer_potential(Case& c, const Origins& origins) {
  if (c.potential.empty() || !has_load(c, LoadKind::pressure)) return;
  for (const char* name : {"E", "nu"})
    if (label_of(origins, name) == fmt::format("--{}", name))
      throw bad_input("--{}: with a potential the membrane takes E·h and nu from the potential's card", name);
  c.E_eV_per_A3.reset();
  c.nu.reset();
}

ReadCase read(const ExperimentCommand& command, const CaseFlags& flags, const RunOptions& options,
              const Variant& variant) {
  ReadCase result{command.defaults, std::nullopt};
  Case& c = result.c;
  Origins origins = options.case_file ? read_case(*options.case_file, c, "--case")
                                      : read_case(inputs_folder() / command.case_file, c);
  flags.apply(c, origins, variant);
  settle_size(c, origins);
  settle_units(c, flags.texts());
  settle_rim(c, origins);
  prefer_potential(c, origins);
  for (const std::string& warning : check(c, origins)) spdlog::warn("{}", warning);
  if (!has_given_constants(c)) {
    result.potential = read_potential(c.potential, inputs_folder() / "potentials", label_of(origins, "potential"),
                                      options.allow_code ? CodeInPotential::allowed : CodeInPotential::refused);
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

int run(const ExperimentCommand& experiment, const CLI::App& command, const CaseFlags& flags,
        const RunOptions& options) {
  check(options);
  const std::vector<Variant> variants = flags.variants();
  if (variants.size() == 1) {
    const ReadCase one = read(experiment, flags, options, variants.front());
    return run_experiment(experiment.name, one.c, options, one.potential);
  }
  std::vector<BatchCase> cases;
  for (const Variant& variant : variants) {  // every case is checked before the first one starts
    const ReadCase one = read(experiment, flags, options, variant);
    BatchCase entry{one.c.potential, one.c.radius_A, {}};
    add_word(entry.words, command, "--potential", variant.potential);
    add_word(entry.words, command, "--radius", variant.radius);
    cases.push_back(std::move(entry));
  }
  return run_batch(experiment.name, cases, common_words(command), options);
}

}  // namespace

void add_experiment(CLI::App& app, const ExperimentCommand& experiment, int& exit_code) {
  CLI::App* command = app.add_subcommand(std::string(to_string(experiment.name)), experiment.description);
  const auto flags = std::make_shared<const CaseFlags>(*command, experiment.defaults);
  const auto options = std::make_shared<RunOptions>();
  add_run_options(*command, *options);
  command->footer(experiment.examples);
  command->callback([=, &exit_code] { exit_code = run(experiment, *command, *flags, *options); });
}

}  // namespace validate
