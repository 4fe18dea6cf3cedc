// `validate design`: what an experiment will tell.
#pragma once

#include <CLI/CLI.hpp>

namespace validate {

void add_design(CLI::App& app, int& exit_code);

}  // namespace validate
