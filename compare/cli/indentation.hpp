// `validate indentation`: options and set-up of the comparison under an indenter.
#pragma once

#include <CLI/CLI.hpp>

namespace validate {

/// Adds the command; when it is the one asked for, parsing runs it and sets the exit code.
void add_indentation(CLI::App& app, int& exit_code);

}  // namespace validate
