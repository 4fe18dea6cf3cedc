// How far a fit is to be trusted: intervals that do not rest on the curvature at the minimum alone.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "compare/fitting/fit.hpp"

namespace validate {

using Interval = std::array<double, 2>;

/// Profile-likelihood intervals: for each parameter the values where the sum of squares, minimised over all
/// the others, has grown by the factor 1 + t²/(n − p), t being Student's quantile (Bates & Watts, Nonlinear
/// Regression Analysis, 1988, ch. 6). For a linear model they are the usual t intervals. `report` is a
/// converged fit of the same data. An end that is not reached within 100 standard errors is infinite.
std::vector<Interval> profile_intervals(const AnyCurveModel& model, std::span<const double> x,
                                        std::span<const double> y, const LeastSquaresReport& report,
                                        const LeastSquaresOptions& options, double confidence = 0.95);

struct Bootstrap {
  std::vector<double> standard_errors;
  std::vector<Interval> intervals;  ///< percentiles
  int samples = 0;                  ///< refits that converged
};

/// Residual bootstrap (Efron 1979): refits the fitted curve plus residuals drawn with replacement, centred
/// and enlarged by √(n/(n − p)), with a seeded generator that gives the same draws on every machine.
Bootstrap bootstrap(const AnyCurveModel& model, std::span<const double> x, const LeastSquaresReport& report,
                    const LeastSquaresOptions& options, int samples, std::uint32_t seed, double confidence = 0.95);

/// The model behind a zero that is not the data's: y = f(x − δ0) + F0, each offset one more parameter at the
/// end where it is asked for.
AnyCurveModel with_offsets(AnyCurveModel model, bool depth_offset, bool force_offset);

}  // namespace validate
