#include "compare/cli/atoms_options.hpp"

#include <spdlog/spdlog.h>

#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "compare/base/child_process.hpp"
#include "compare/base/errors.hpp"
#include "compare/base/paths.hpp"

namespace validate {
namespace {

std::vector<std::string> words(const std::string& text) {
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), {}};
}

}  // namespace

AtomsLaunch launch_of(const RunOptions& options) {
  AtomsLaunch launch{.program = atoms_program(), .launcher = words(options.launcher), .cores = available_cores()};
  if (!launch.launcher.empty()) launch.cores = 1;  // it owns the machine: one job at a time
  if (!launch.launcher.empty() && !find_program(launch.launcher.front()))
    throw Error(ExitCode::atomistic_failed,
                fmt::format("--launcher: '{}' cannot be started: no such program in PATH", launch.launcher.front()));
  if (launch.launcher.empty() && !has_mpiexec()) {
    if (options.ranks > 1)
      throw Error(ExitCode::atomistic_failed,
                  "--ranks: 'mpiexec' is not in PATH; install Open MPI or give another launcher with --launcher");
    spdlog::warn("mpiexec is not in PATH: the atoms run on one rank");
  }
  return launch;
}

nlohmann::ordered_json definition_of(const PotentialFile& potential) {
  const atomistic::Potential& p = potential.potential;
  return {p.pair_style, p.pair_coeff, p.kim_model, potential.sha256, p.mass, p.interaction_range_A, p.artefact_bond_A};
}

}  // namespace validate
