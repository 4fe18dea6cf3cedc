// validate bulge: a sheet under pressure.
#pragma once

#include <CLI/CLI.hpp>

namespace compare {

void add_bulge(CLI::App& app, int& exit_code);

}  // namespace compare
