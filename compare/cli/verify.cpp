#include "compare/cli/verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
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
#include "compare/documents/texts/verify_table.hpp"
#include "compare/potential/potential_card.hpp"
#include "compare/process/document_folder.hpp"
#include "compare/process/provenance.hpp"
#include "compare/verify/groups.hpp"
#include "compare/verify_atoms/groups.hpp"
#include "compare/verify_fit/groups.hpp"

namespace validate {
namespace {

using verify::Group;

struct VerifyFlags {
  std::string what;
  std::vector<std::string> groups, potentials;
  OutputOptions output;
  std::string json;
  bool quiet = false, full = false;
};

using verify::Laboratory;

/// What can be verified: groups that the laboratory, where there is one, is handed to.
struct Part {
  std::string_view name;
  std::vector<Group> (*groups)(const std::shared_ptr<Laboratory>&);
  bool atomistic;
};

std::vector<Group> membrane_groups(const std::shared_ptr<Laboratory>&) {
  return {verify::groups().begin(), verify::groups().end()};
}

std::vector<Group> wrinkles_groups(const std::shared_ptr<Laboratory>&) {
  return {verify::wrinkles_groups().begin(), verify::wrinkles_groups().end()};
}

const std::vector<Part>& parts() {
  static const std::vector<Part> all = {{"membrane", membrane_groups, false},
                                        {"wrinkles", wrinkles_groups, false},
                                        {"atoms", verify::atoms_groups, true},
                                        {"calibration", verify::calibration_groups, true},
                                        {"fit", [](const auto&) { return verify::fit_groups(false); }, false}};
  return all;
}

std::vector<std::string_view> part_names() {
  std::vector<std::string_view> names;
  for (const Part& part : parts()) names.push_back(part.name);
  return names;
}

const Part& part_of(const std::string& what) {
  for (const Part& part : parts())
    if (part.name == what) return part;
  const auto names = part_names();
  throw bad_input("verify: '{}' is none; allowed: {}{}", what, fmt::join(names, ", "), did_you_mean(what, names));
}

const std::vector<std::string> usual_potentials = {"airebo", "rebo", "tersoff", "lcbop"};

std::shared_ptr<Laboratory> laboratory_for(const Part& part, const VerifyFlags& flags) {
  if (!part.atomistic) {
    if (!flags.potentials.empty()) throw bad_input("--potential: verify {} has none", part.name);
    return nullptr;
  }
  catch_interrupts();
  const auto& chosen = flags.potentials.empty() ? usual_potentials : flags.potentials;
  return std::make_shared<Laboratory>(
      Laboratory::Means{.launch = {.program = atoms_program(), .launcher = {}, .cores = 2},
                        .potentials = inputs_folder() / "potentials",
                        .cards = card_cache(),
                        .chosen = chosen});
}

const Group& group_of(const std::vector<Group>& all, const std::string& name) {
  std::vector<std::string_view> names;
  for (const Group& group : all) {
    if (group.name == name) return group;
    names.push_back(group.name);
  }
  throw bad_input("--group: '{}' is none; allowed: {}{}", name, fmt::join(names, ", "), did_you_mean(name, names));
}

std::vector<Group> chosen(const VerifyFlags& flags) {
  if (flags.full && flags.what != "fit") throw bad_input("--full: is of `verify fit` alone");
  const Part& part = part_of(flags.what);
  const std::vector<Group> all = flags.full ? verify::fit_groups(true) : part.groups(laboratory_for(part, flags));
  std::vector<Group> result;
  for (const std::string& name : flags.groups) result.push_back(group_of(all, name));
  if (result.empty()) result = all;
  return result;
}

std::vector<VerificationRow> rows_of(const std::vector<Group>& groups, Progress& progress) {
  std::vector<VerificationRow> rows;
  for (const Group& group : groups) {
    const auto on_row = [&](const VerificationRow& row) {
      progress.status(fmt::format("{}: {}", row.group, row.name));
    };
    const double start = progress.elapsed_s();
    const auto found = verify::run(group, on_row);
    const auto failed = std::ranges::count_if(found, [](const VerificationRow& row) { return !row.pass; });
    progress.say(fmt::format("{}: {} rows, {} failed, {:.1f} s", group.name, found.size(), failed,
                             progress.elapsed_s() - start));
    rows.insert(rows.end(), found.begin(), found.end());
  }
  return rows;
}

void write_files(const VerifyFlags& flags, const Result& result, const std::string& json) {
  if (!flags.json.empty() && flags.json != "-") write_users_file(flags.json, json);
  if (!flags.output.out) return;
  OutputFolder folder(*flags.output.out, flags.output.overwrite);
  write_file(folder.drafts() / "verify.csv", verification_csv(result.rows));
  write_file(folder.drafts() / "verify.json", json);
  folder.finish(result.exit_code);
}

/// Exit code 3 where a row fails.
int verify_command(const VerifyFlags& flags) {
  const std::vector<Group> groups = chosen(flags);
  Progress progress(flags.quiet);
  Result result = verification_result(rows_of(groups, progress));
  result.provenance = provenance(command_line());
  const std::string json = json_text(result);
  write_files(flags, result, json);
  if (flags.json == "-")
    print_result(json);
  else
    print_text(verification_text(result.rows, line_width()));
  return result.exit_code;
}

std::string footer() {
  std::string text;
  for (const Part& part : parts()) {
    text += fmt::format("Groups of {}:\n", part.name);
    for (const Group& group : part.groups(nullptr)) text += fmt::format("  {:11} {}\n", group.name, group.what);
  }
  return text +
         "\nEvery row names where its reference comes from: a closed form, a publication, or a solver that "
         "shares no "
         "code\nwith the membrane. `allowed` is relative (absolute where the reference is 0) and follows "
         "from the "
         "error that\ntwo meshes foretell. The last line counts the rows that rest on numbers from outside and those "
         "that check the "
         "code\nagainst itself. atoms and calibration ask validate-atoms, for each potential. Exit code 0 if every row "
         "passes, 3 if one fails.\n\n"
         "Examples:\n  validate verify membrane\n  validate verify atoms --potential tersoff\n  validate verify "
         "membrane --group point,disc --out "
         "verified\n"
         "  validate verify membrane --json - | python3 -m json.tool";
}

}  // namespace

void add_verify(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("verify", "membrane, atoms, calibration and fits against independent references, as a table");
  const auto flags = std::make_shared<VerifyFlags>();
  command->add_option("what", flags->what, fmt::format("what to verify: {}", fmt::join(part_names(), ", ")))
      ->required()
      ->type_name("WHAT");
  command->add_option("--group", flags->groups, "these groups only; default all")
      ->delimiter(',')
      ->type_name("NAME,...");
  command
      ->add_option("--potential", flags->potentials,
                   fmt::format("of atoms and calibration; default {}", fmt::join(usual_potentials, ",")))
      ->delimiter(',')
      ->type_name("NAME,...");
  add_output_options(*command, flags->output, "folder for verify.csv and verify.json");
  command->add_option("--json", flags->json, "write the rows as JSON; - for stdout, instead of the table")
      ->type_name("FILE");
  command->add_flag("--full", flags->full, "fit: three thousand curves a case in place of eighty (minutes)");
  command->add_flag("--quiet", flags->quiet, "no progress on stderr");
  command->footer(footer());
  command->callback([flags, &exit_code] { exit_code = verify_command(*flags); });
}

}  // namespace validate
