// `validate potential NAME`: the card of a potential.
#pragma once

#include <CLI/CLI.hpp>

namespace validate {

/// Adds the command; when it is the one asked for, parsing runs it and sets the exit code.
void add_potential(CLI::App& app, int& exit_code);

}  // namespace validate
