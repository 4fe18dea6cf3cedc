// `validate export`: models for other programs.
#pragma once

#include <CLI/CLI.hpp>

namespace validate {

void add_export(CLI::App& app, int& exit_code);

}  // namespace validate
