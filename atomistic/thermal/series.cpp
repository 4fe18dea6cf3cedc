#include "atomistic/thermal/series.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace atomistic {
namespace {

/// The start of what is left when the mean is known best; by sums from the end, in steps of five values.
std::size_t warm_up_of(const std::vector<double>& x) {
  constexpr std::size_t batch = 5;
  std::vector<double> means;
  for (std::size_t i = 0; i + batch <= x.size(); i += batch) {
    double sum = 0;
    for (std::size_t k = 0; k < batch; ++k) sum += x[i + k];
    means.push_back(sum / batch);
  }
  double sum = 0, squares = 0, least = std::numeric_limits<double>::infinity();
  std::size_t best = 0;
  for (std::size_t i = means.size(); i-- > 0;) {
    sum += means[i];
    squares += means[i] * means[i];
    const double count = static_cast<double>(means.size() - i);
    const double error = (squares - sum * sum / count) / (count * count);
    if (2 * i <= means.size() && count > 1 && error < least) least = error, best = i;
  }
  return batch * best;
}

double correlation(const std::vector<double>& x, std::size_t first, double mean, std::size_t lag) {
  double sum = 0;
  for (std::size_t i = first; i + lag < x.size(); ++i) sum += (x[i] - mean) * (x[i + lag] - mean);
  return sum / static_cast<double>(x.size() - first);
}

}  // namespace

SeriesMean mean_of(const std::vector<double>& x) {
  constexpr double window = 10;
  SeriesMean found;
  found.error = std::numeric_limits<double>::infinity();
  if (x.size() < 20) return found;
  found.warm_up = warm_up_of(x);
  const double count = static_cast<double>(x.size() - found.warm_up);
  for (std::size_t i = found.warm_up; i < x.size(); ++i) found.mean += x[i] / count;
  const double variance = correlation(x, found.warm_up, found.mean, 0);
  double tau = 0.5;
  for (std::size_t lag = 1; lag < x.size() - found.warm_up && static_cast<double>(lag) < window * tau; ++lag)
    tau += correlation(x, found.warm_up, found.mean, lag) / variance;
  found.correlation_length = std::max(tau, 0.5);
  found.deviation = std::sqrt(variance);
  found.samples = count / (2 * found.correlation_length);
  found.error = found.deviation / std::sqrt(found.samples);
  return found;
}

}  // namespace atomistic
