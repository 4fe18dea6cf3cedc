// `validate model`: the closed forms and what they say.
#pragma once

#include <CLI/CLI.hpp>

namespace validate {

void add_model(CLI::App& app, int& exit_code);

}  // namespace validate
