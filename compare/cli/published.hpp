// `validate published`: published numbers, ours computed beside them.
#pragma once

#include <CLI/CLI.hpp>

namespace validate {

/// Adds the command; when it is the one asked for, parsing runs it and sets the exit code.
void add_published(CLI::App& app, int& exit_code);

}  // namespace validate
