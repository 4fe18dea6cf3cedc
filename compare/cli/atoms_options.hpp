// What commands with atoms make of their options.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "compare/input/potential_file.hpp"
#include "compare/input/run_options.hpp"
#include "compare/process/atoms.hpp"

namespace validate {

/// How LAMMPS is to be started; a warning where mpiexec is missing. Throws Error (atomistic failed) for a launcher that
/// is not there, or ranks without one.
AtomsLaunch launch_of(const RunOptions& options);

/// What a potential's name stands for: part of a run's identity.
nlohmann::ordered_json definition_of(const PotentialFile& potential);

}  // namespace validate
