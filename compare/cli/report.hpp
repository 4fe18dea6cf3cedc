// `validate report`: the page of a run, made again from its run.h5.
#pragma once

#include <CLI/CLI.hpp>

namespace validate {

void add_report(CLI::App& app, int& exit_code);

}  // namespace validate
