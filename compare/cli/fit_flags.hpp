// The flags of `validate fit` as they were typed, and what they say.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/cli/flags.hpp"
#include "compare/fitting/measured_options.hpp"
#include "compare/instruments/measured.hpp"
#include "compare/potential/potential_card.hpp"

namespace validate {

/// The flags as they were typed; a key of the file's remarks stands in for one that was not.
struct FitFlags {
  std::vector<std::string> files;
  std::string radius, nu, tip, tip_radius, bending, model = "eq16", weights = "automatic";
  std::string depth_column, force_column, sigma_column;
  std::string depth_min, depth_max, baseline, contact;
  std::string potential, third_order;
  std::string sigma_force, sigma_depth, spring_constant, sensitivity, sensitivity_error, segment = "approach", curves;
  bool fit_force_zero = false, fit_slope = false;
  int bootstrap = 0;
  unsigned seed = 1;
  OutputOptions output;
  std::string json;
};

/// What is read of the files. A spring constant makes forces of deflections where a file has none of its own. Throws
/// Error (bad input) that names the flag.
MeasuredRequest request_of(const FitFlags& flags);

/// What is said about the experiment of a curve, with the card of the potential whose sheet is fitted. Throws Error
/// (bad input) that names the flag, or the file and its remark.
MeasuredOptions options_of(const FitFlags& flags, const MeasuredCurve& curve, const std::optional<PotentialCard>& card);

}  // namespace validate
