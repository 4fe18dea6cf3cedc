#include "compare/cli/schema.hpp"

#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "compare/base/errors.hpp"
#include "compare/base/nearest.hpp"
#include "compare/base/standard_streams.hpp"
#include "compare/documents/texts/schema.hpp"

namespace validate {
namespace {

int schema(const std::string& name) {
  std::vector<std::string_view> names;
  for (const NamedSchema& one : named_schemas) {
    names.push_back(one.name);
    if (one.name != name) continue;
    print_result(schema_text(one.command));
    return 0;
  }
  throw bad_input("schema: '{}' is none; allowed: {}{}", name, fmt::join(names, ", "), did_you_mean(name, names));
}

}  // namespace

void add_schema(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("schema", "the JSON schema of a document");
  const auto name = std::make_shared<std::string>();
  std::string list = "which document:";
  for (const NamedSchema& one : named_schemas) list += fmt::format(" {}", one.name);
  command->add_option("name", *name, list)->required()->type_name("NAME");
  command->footer("Example:\n  validate schema summary > summary.schema.json");
  command->callback([name, &exit_code] { exit_code = schema(*name); });
}

}  // namespace validate
