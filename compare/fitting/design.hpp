// What an experiment will tell of a sheet, before it is made.
#pragma once

#include <optional>

#include "compare/fitting/measured_options.hpp"
#include "compare/results/design.hpp"

namespace validate {

struct Experiment {
  MeasuredOptions options;  ///< drum, tip, cantilever and their errors
  double Eh_eV_per_A2 = 0, pretension_eV_per_A2 = 0;
  double depth_A = 0;            ///< largest
  double noise_eV_per_A = 0;     ///< of the force
  double height_noise_A = 0;     ///< of the piezo's position, or of the depth where there is no cantilever
  double before = 1;             ///< way without contact over the way in contact
  int points = 500, curves = 1;  ///< curves of one drum, in one joint fit
  std::optional<double> target;  ///< standard error of E·h over E·h
};

/// Standard errors by the Fisher information of the likelihood that a fit maximises, contact, zero of force and slope
/// of the baseline free. Throws std::runtime_error where the sheet is not solved.
DesignRow expected(const Experiment& experiment, std::string what);

/// The experiment, then one thing changed at a time: by what reaches the target, or as far as it goes; without a target
/// to twice or half of what it is.
Design design(const Experiment& experiment);

}  // namespace validate
