// An experiment as a command: `indentation` and `bulge` are two sets of defaults over it.
#pragma once

#include <CLI/CLI.hpp>

#include "compare/input/case.hpp"
#include "compare/results/result.hpp"

namespace validate {

/// What tells the experiments' commands apart.
struct ExperimentCommand {
  Command name;
  const char* description;
  Case defaults;
  const char* case_file;  ///< in inputs/; read where no other is given
  const char* examples;
};

void add_experiment(CLI::App& app, const ExperimentCommand& command, int& exit_code);

}  // namespace validate
