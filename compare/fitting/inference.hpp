// One curve of points read with one model: E·h and pretension, with errors that say where they come from.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "compare/fitting/likelihood.hpp"
#include "compare/results/fit.hpp"

namespace validate {

struct InferenceOptions {
  FreeZeros free;
  std::vector<UncertainInput> inputs;
  bool contact_profile =
      true;  ///< the contact's error by its own profile; else by the covariance, at a third less time
  int bootstrap_samples = 0;
  std::uint32_t seed = 1;
};

/// The most likely E·h and σ0·h of measured points, 95 % intervals by profile likelihood over noise, zeros and inputs.
/// `model` of the fit is left empty. Returns why there is none instead.
std::variant<Fit, std::string> infer(const CurvePoints& points, const ForceModel& model,
                                     const InferenceOptions& options);

/// Order in the signs of residuals (in the order of the depth): standard errors by which they change more seldom than
/// those of independent noise (Wald & Wolfowitz, Ann. Math. Stat. 11 (1940) 147). NaN for fewer than ten of each sign.
double runs_z(const std::vector<double>& residuals);

}  // namespace validate
