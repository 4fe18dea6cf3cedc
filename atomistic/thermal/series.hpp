// The mean of a correlated series and how well it is known.
#pragma once

#include <cstddef>
#include <vector>

namespace atomistic {

struct SeriesMean {
  std::size_t warm_up = 0;        ///< values at the start that are left out
  double mean = 0, error = 0;     ///< standard error
  double deviation = 0;           ///< of the single values
  double correlation_length = 0;  ///< integrated autocorrelation, in values: 1/2 for independent ones
  double samples = 0;             ///< independent values that the series is worth
};

/// The warm-up is where the standard error of what is left is smallest (White, Simulation 69 (1997) 323), at most half
/// of the series. The error is by the integrated autocorrelation, summed up to ten times itself (Sokal's window).
SeriesMean mean_of(const std::vector<double>& series);

}  // namespace atomistic
