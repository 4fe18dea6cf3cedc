// Langevin dynamics of a sheet under a dead force: the check of the quasi-harmonic shift.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "atomistic/lammps/lammps.hpp"
#include "atomistic/problem.hpp"
#include "atomistic/temperature.hpp"

namespace atomistic {

/// Starts from the step's equilibrium, or goes on with what an earlier run has kept, stretch by stretch of 1 ps, until
/// the length asked for is sampled or the mean depth is known to the error asked for. The classical mean conjugate
/// depth at the step's force. `keep` is called after each stretch. Point and disc loads; one rank. Throws
/// std::invalid_argument for other loads, std::runtime_error where the sheet comes apart.
Sampled sample_level(const Problem& problem, const Step& step, const Sampling& sampling, const std::string& log_file,
                     const std::optional<Sampled>& kept, const std::function<void(const Sampled&)>& keep);

/// The mean, its error and its warm-up, from the depths.
void evaluate(Sampled& sampled);

}  // namespace atomistic
