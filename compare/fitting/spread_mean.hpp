// Means of values that scatter more than their errors say.
#pragma once

#include <vector>

#include "compare/results/many.hpp"

namespace validate {

struct RandomEffects {
  double mean = 0, standard_error = 0;
  double within = 0;   ///< rms of the errors
  double between = 0;  ///< standard deviation τ of the true values
};

/// x_i = μ + N(0, τ²) + N(0, s_i²): τ² is what makes the weighted squares about the mean what they should be, n − 1
/// (Paule & Mandel, J. Res. Natl. Bur. Stand. 87 (1982) 377); none where they are less already. Errors > 0.
RandomEffects random_effects(const std::vector<double>& values, const std::vector<double>& errors);

/// Over the curves that are used, and over the drums, a file each, where there are more than one.
std::vector<SpreadMean> spread_means(const std::vector<CurveRow>& rows);

}  // namespace validate
