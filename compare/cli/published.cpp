#include "compare/cli/published.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compare/base/errors.hpp"
#include "compare/base/file.hpp"
#include "compare/base/interrupt.hpp"
#include "compare/base/nearest.hpp"
#include "compare/base/paths.hpp"
#include "compare/base/progress.hpp"
#include "compare/base/standard_streams.hpp"
#include "compare/base/terminal.hpp"
#include "compare/cli/flags.hpp"
#include "compare/documents/texts/json.hpp"
#include "compare/documents/texts/published_table.hpp"
#include "compare/potential/potential_card.hpp"
#include "compare/process/document_folder.hpp"
#include "compare/process/provenance.hpp"
#include "compare/published/compare.hpp"

namespace validate {
namespace {

using published::Entry;

struct PublishedFlags {
  std::vector<std::string> files, only, potentials;
  OutputOptions output;
  std::string json;
  bool quiet = false;
};

/// Of the shipped file and of the user's, the shipped ones first.
std::vector<Entry> all_entries(const PublishedFlags& flags) {
  std::vector<Entry> entries = published::read_entries(inputs_folder() / "published.toml", "published.toml");
  for (const std::string& file : flags.files)
    for (Entry& entry : published::read_entries(file, "--file")) entries.push_back(std::move(entry));
  return entries;
}

/// Those whose name starts with what --only asks for.
std::vector<Entry> chosen_entries(const PublishedFlags& flags) {
  const std::vector<Entry> all = all_entries(flags);
  if (flags.only.empty()) return all;
  std::vector<std::string_view> names;
  for (const Entry& entry : all)
    if (std::ranges::count(names, entry.name) == 0) names.push_back(entry.name);
  for (const std::string& wanted : flags.only)
    if (std::ranges::none_of(names, [&](std::string_view name) { return name.starts_with(wanted); }))
      throw bad_input("--only: no row's name starts with '{}'; there are: {}{}", wanted, fmt::join(names, "; "),
                      did_you_mean(wanted, names));
  std::vector<Entry> chosen;
  for (const Entry& entry : all)
    if (std::ranges::any_of(flags.only, [&](const std::string& wanted) { return entry.name.starts_with(wanted); }))
      chosen.push_back(entry);
  return chosen;
}

std::vector<PublishedRow> computed(const PublishedFlags& flags) {
  const std::vector<Entry> entries = chosen_entries(flags);
  Progress progress(flags.quiet);
  const std::vector<std::string> usual = {"airebo", "rebo", "tersoff", "lcbop"};
  return published::compared(entries, {.potentials = inputs_folder() / "potentials",
                                       .chosen = flags.potentials.empty() ? usual : flags.potentials,
                                       .chosen_alone = !flags.potentials.empty(),
                                       .launch = {.program = atoms_program(), .launcher = {}, .cores = 1},
                                       .cards = card_cache(),
                                       .progress = progress});
}

void write_files(const PublishedFlags& flags, const Result& result, const std::string& json) {
  if (!flags.json.empty() && flags.json != "-") write_users_file(flags.json, json);
  if (!flags.output.out) return;
  OutputFolder folder(*flags.output.out, flags.output.overwrite);
  write_file(folder.drafts() / "published.csv", published_csv(result.beside));
  write_file(folder.drafts() / "published.json", json);
  folder.finish(result.exit_code);
}

/// A comparison, no test: exit code 0 however far ours is off.
int published_command(const PublishedFlags& flags) {
  if (!flags.json.empty()) check_json_target(flags.json);
  catch_interrupts();
  Result result = published_result(computed(flags));
  result.provenance = provenance(command_line());
  const std::string json = json_text(result);
  write_files(flags, result, json);
  if (flags.json == "-")
    print_result(json);
  else
    print_text(published_text(result.beside));
  return result.exit_code;
}

std::string published_footer() {
  std::string text =
      "Each published number stands with its source, conditions and uncertainty; ours are computed now: a potential's\n"
      "from its card (kept from earlier runs), the others by the membrane's equations or the paper's figures.\n"
      "z = (ours - published) / uncertainty; where none was published there is no z. `not comparable` says why both "
      "do\n"
      "not mean the same, such as 300 K beside T = 0. It is a comparison, not a test: exit code 0 once it is "
      "computed.\n\n"
      "Rows of your own (--file mine.toml), one table each; the shipped ones are in inputs/published.toml:\n\n"
      "  [[row]]\n"
      "  name = \"E·h of my sheet\"\n"
      "  quantity = \"Eh\"             # see below\n"
      "  published = 335\n"
      "  uncertainty = 8             # left out where none was published\n"
      "  unit = \"N/m\"\n"
      "  conditions = \"indentation, 300 K, drums of 1 um\"\n"
      "  comparable = false\n"
      "  reason = \"300 K\"            # with comparable = false\n"
      "  source = \"lab book 7\"       # doi and arxiv are keys of their own\n"
      "  # potentials = [\"tersoff\"]  # whose card; left out: those of --potential\n"
      "  # relation = \">=\"           # a bound instead of a number\n\n"
      "Quantities:\n";
  for (const auto& word : words(published::Subject{}))
    text += fmt::format("  {:28} {}\n", word.name, published::meaning_of(word.value));
  return text +
         "\nExamples:\n  validate published\n  validate published --only Lee --potential tersoff,lcbop\n"
         "  validate published --file mine.toml --json - | python3 -m json.tool";
}

}  // namespace

void add_published(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("published", "published numbers, ours computed beside them, with z-scores");
  const auto flags = std::make_shared<PublishedFlags>();
  command->add_option("--file", flags->files, "rows of your own, beside the shipped ones")->type_name("FILE");
  command->add_option("--only", flags->only, "rows whose name starts so; may be given again")->type_name("NAME");
  command
      ->add_option("--potential", flags->potentials,
                   "whose cards; default airebo,rebo,tersoff,lcbop, and those that a row names")
      ->delimiter(',')
      ->type_name("NAME,...");
  add_output_options(*command, flags->output, "folder for published.csv and published.json");
  command->add_option("--json", flags->json, "write the rows as JSON; - for stdout, instead of the table")
      ->type_name("FILE");
  command->add_flag("--quiet", flags->quiet, "no progress on stderr");
  command->footer(published_footer());
  command->callback([flags, &exit_code] { exit_code = published_command(*flags); });
}

}  // namespace validate
