// `validate schema`: the JSON schema of a document.
#pragma once

#include <CLI/CLI.hpp>

namespace validate {

void add_schema(CLI::App& app, int& exit_code);

}  // namespace validate
