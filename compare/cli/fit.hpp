// `validate fit`: measured curves.
#pragma once

#include <CLI/CLI.hpp>

namespace validate {

void add_fit(CLI::App& app, int& exit_code);

}  // namespace validate
