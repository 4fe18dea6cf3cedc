// validate curve: what is in an instrument's file.
#pragma once

#include <CLI/CLI.hpp>

namespace validate {

/// Adds the command; `exit_code` is set when it has run.
void add_curve(CLI::App& app, int& exit_code);

}  // namespace validate
