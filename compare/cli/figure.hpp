// `validate figure`: the paper's figures, from scratch.
#pragma once

#include <CLI/CLI.hpp>

namespace validate {

void add_figure(CLI::App& app, int& exit_code);

}  // namespace validate
