// What a user says about a measured curve: the sheet, the tip, the instrument, and what is sought.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "compare/fitting/likelihood.hpp"
#include "compare/fitting/models/list.hpp"
#include "compare/fitting/sheet_physics.hpp"

namespace validate {

/// How much the points count: by the file's σ where it has one, else all alike; all alike; by 1/force²; by the file's
/// σ.
enum class Weighting { automatic, uniform, relative, sigma };

/// Standard errors of what the user says about the experiment; 0: exact.
struct InputErrors {
  ModelGeometry geometry;           ///< of radius, ν, tip radius and κ
  double force_scale_relative = 0;  ///< of the spring constant: all forces are wrong by it together
  double sensitivity_relative = 0;  ///< of the deflection: forces, and depths by force / spring constant
};

/// What the user says about the experiment.
struct MeasuredOptions {
  ModelGeometry geometry;  ///< radius, ν, tip radius, κ
  InputErrors errors;
  bool sphere = true;                              ///< the tip; else a disc of uniform load
  std::string model = "eq16";                      ///< closed form that is fitted
  std::optional<SheetPhysics> physics;             ///< of the sheet that is fitted beside the paper's membrane
  std::optional<double> depth_min_A, depth_max_A;  ///< points used: depths of the file minus `contact_A`
  std::optional<double> baseline_to_A;             ///< mean force of the points up to this raw depth is taken off
  double contact_A = 0;                            ///< raw depth of the contact point, taken off
  FreeZeros free;                                  ///< sought in every model
  Weighting weighting = Weighting::automatic;
  std::optional<double> sigma_force_eV_per_A, sigma_depth_A;  ///< noise; absent: the file's, else estimated
  std::optional<double> spring_constant_eV_per_A2;            ///< of the cantilever
  bool quoted_alone = false;  ///< of many curves: the closed form only where the membrane cannot be fitted, no scan
  int bootstrap_samples = 0;
  std::uint32_t seed = 1;
};

}  // namespace validate
