// `validate verify`: the membrane against closed forms, publications and independent solvers.
#pragma once

#include <CLI/CLI.hpp>

namespace validate {

void add_verify(CLI::App& app, int& exit_code);

}  // namespace validate
