#include "compare/cli/potential.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <memory>
#include <optional>
#include <string>

#include "compare/base/errors.hpp"
#include "compare/base/file.hpp"
#include "compare/base/interrupt.hpp"
#include "compare/base/paths.hpp"
#include "compare/base/terminal.hpp"
#include "compare/cli/flags.hpp"
#include "compare/documents/texts/card_files.hpp"
#include "compare/documents/texts/json.hpp"
#include "compare/potential/potential_card.hpp"
#include "compare/potential/switch_length.hpp"
#include "compare/process/document_folder.hpp"
#include "compare/study/heating.hpp"
#include "compare/study/summaries.hpp"

namespace validate {
namespace {

namespace fs = std::filesystem;

constexpr const char* potential_examples =
    R"(A name is looked up in inputs/potentials (kim/hnn-2019 is one too); a path to a TOML file works as well.

Examples:
  validate potential tersoff
  validate potential tersoff --temperature 300
  validate potential airebo --switch-length 1.92 --out airebo-1.92
  validate potential mine.toml --json -)";

struct Options {
  std::string name, switch_length, temperature;
  OutputOptions output;
  std::optional<fs::path> json;
  bool refresh = false, allow_code = false;
};

double parsed_switch_length(const std::string& text) {
  std::optional<double> length;
  const Case defaults;
  describe(defaults, [&](const Field& field, const auto&) {
    if (field.name == "switch-length") length = parse_number(field, text, "--switch-length");
  });
  return length.value();
}

double parsed_temperature(const std::string& text) {
  std::optional<double> temperature;
  const Case defaults;
  describe(defaults, [&](const Field& field, const auto&) {
    if (field.name == "temperature") temperature = parse_number(field, text, "--temperature");
  });
  constexpr double lowest_K = 10;  // below, quantum statistics would sum without end
  if (!(temperature.value() >= lowest_K))
    throw bad_input("--temperature: {} K; at least {} K, or none for T = 0", temperature.value(), lowest_K);
  return temperature.value();
}

/// Card and law, and at a temperature the flat sheet's, of both statistics.
Result computed(const PotentialFile& file, const Options& options) {
  std::optional<double> temperature;
  if (!options.temperature.empty()) temperature = parsed_temperature(options.temperature);
  const AtomsLaunch launch{.program = atoms_program(), .launcher = {}, .cores = 1};
  const PotentialCard card = potential_card(file, launch, card_cache(), options.refresh);
  Result result = potential_result(card);
  if (!temperature) return result;
  for (const auto statistics : {atomistic::Statistics::classical, atomistic::Statistics::quantum})
    result.warm.push_back(summary_of(
        warm_potential(card, {.temperature_K = *temperature, .statistics = statistics}, {}, launch).card, card.card));
  return result;
}

int potential(const Options& options) {
  PotentialFile file = read_potential(options.name, inputs_folder() / "potentials", "NAME",
                                      options.allow_code ? CodeInPotential::allowed : CodeInPotential::refused);
  for (const std::string& warning : file.warnings) spdlog::warn("{}", warning);
  std::optional<OutputFolder> folder;
  const auto open_folder = [&] {
    if (options.output.out && !folder) folder.emplace(*options.output.out, options.output.overwrite);
  };
  if (!options.switch_length.empty()) {
    const double length = parsed_switch_length(options.switch_length);
    check_switch(file, "--switch-length");
    if (!options.output.out)
      throw bad_input("--switch-length: the changed copy of the file needs a folder: add --out DIR");
    open_folder();
    file = with_switch_at(file, length, *folder, "--switch-length");
  }
  catch_interrupts();
  const Result result = computed(file, options);
  open_folder();
  if (folder) {
    if (const auto missing = write_card_files(result, folder->drafts())) spdlog::warn("{}", *missing);
    folder->finish(0);
  }
  if (options.json) write_json(result, options.json->string());
  if (!options.json || *options.json != "-") print_text(card_table(result));
  return 0;
}

}  // namespace

void add_potential(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("potential", "what a potential says of flat graphene: moduli, strength, bending");
  const auto options = std::make_shared<Options>();
  command->add_option("NAME", options->name, "name in inputs/potentials, or path to a TOML file")->required();
  add_output_options(*command, options->output, "folder for card.json, law.toml, stress-strain.csv, .svg, .png");
  command->add_option("--json", options->json, "write the card there; - is stdout")->type_name("FILE");
  command->add_option("--switch-length", options->switch_length, "move the C-C switch of AIREBO or REBO there, Å")
      ->type_name("VALUE");
  command->add_option("--temperature", options->temperature, "the flat sheet at it too: lattice constant, E·h, nu; K")
      ->type_name("VALUE");
  command->add_flag("--refresh", options->refresh, "compute anew even if this card is kept from an earlier run");
  command->add_flag("--allow-code", options->allow_code, "let the potential bring a program of its own");
  command->footer(potential_examples);
  command->callback([options, &exit_code] { exit_code = potential(*options); });
}

}  // namespace validate
