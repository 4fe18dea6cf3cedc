#include "compare/cli/verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "compare/base/errors.hpp"
#include "compare/base/file.hpp"
#include "compare/base/nearest.hpp"
#include "compare/base/progress.hpp"
#include "compare/cli/flags.hpp"
#include "compare/documents/texts/json.hpp"
#include "compare/documents/texts/verify_table.hpp"
#include "compare/process/document_folder.hpp"
#include "compare/process/provenance.hpp"
#include "compare/verify/groups.hpp"

namespace validate {
namespace {

using verify::Group;

struct VerifyFlags {
  std::string what;
  std::vector<std::string> groups;
  OutputOptions output;
  std::string json;
  bool quiet = false;
};

const Group& group_of(const std::string& name) {
  std::vector<std::string_view> names;
  for (const Group& group : verify::groups()) {
    if (group.name == name) return group;
    names.push_back(group.name);
  }
  throw bad_input("--group: '{}' is none; allowed: {}{}", name, fmt::join(names, ", "), did_you_mean(name, names));
}

std::vector<Group> chosen(const VerifyFlags& flags) {
  constexpr std::string_view only = "membrane";
  if (flags.what != only)
    throw bad_input("verify: '{}' is none; allowed: {}{}", flags.what, only, did_you_mean(flags.what, {&only, 1}));
  std::vector<Group> result;
  for (const std::string& name : flags.groups) result.push_back(group_of(name));
  if (result.empty()) result.assign(verify::groups().begin(), verify::groups().end());
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
  if (!flags.json.empty() && flags.json != "-") write_file(flags.json, json);
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
  fmt::print("{}", flags.json == "-" ? json : verification_text(result.rows));
  return result.exit_code;
}

std::string footer() {
  std::string text = "Groups:\n";
  for (const Group& group : verify::groups()) text += fmt::format("  {:10} {}\n", group.name, group.what);
  return text +
         "\nEvery row names where its reference comes from: a closed form, a publication, or a solver that "
         "shares no "
         "code\nwith the membrane. `allowed` is relative (absolute where the reference is 0) and follows "
         "from the "
         "error that\ntwo meshes foretell. Exit code 0 if every row passes, 3 if one fails.\n\n"
         "Examples:\n  validate verify membrane\n  validate verify membrane --group point,disc --out "
         "verified\n"
         "  validate verify membrane --json - | python3 -m json.tool";
}

}  // namespace

void add_verify(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("verify", "the membrane against independent references, as a table");
  const auto flags = std::make_shared<VerifyFlags>();
  command->add_option("what", flags->what, "what to verify: membrane")->required()->type_name("membrane");
  command->add_option("--group", flags->groups, "these groups only; default all")
      ->delimiter(',')
      ->type_name("NAME,...");
  add_output_options(*command, flags->output, "folder for verify.csv and verify.json");
  command->add_option("--json", flags->json, "write the rows as JSON; - for stdout, instead of the table")
      ->type_name("FILE");
  command->add_flag("--quiet", flags->quiet, "no progress on stderr");
  command->footer(footer());
  command->callback([flags, &exit_code] { exit_code = verify_command(*flags); });
}

}  // namespace validate
