// validate bulge: a sheet under pressure.
#pragma once

#include <CLI/CLI.hpp>

namespace validate {

void add_bulge(CLI::App& app, int& exit_code);

}  // namespace validate
