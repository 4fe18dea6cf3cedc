#include "compare/figures/undulation.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

namespace validate {

Undulation undulation_of(const std::vector<double>& place_A, const std::vector<double>& height_A) {
  const auto n = static_cast<Eigen::Index>(place_A.size());
  if (n < 16 || place_A.size() != height_A.size())
    throw std::invalid_argument("undulation: 16 points or more are needed");
  const double first = place_A.front(), length = place_A.back() - first;
  Eigen::MatrixXd powers(n, 5);
  Eigen::VectorXd height(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double s = 2 * (place_A[static_cast<std::size_t>(i)] - first) / length - 1;
    height[i] = height_A[static_cast<std::size_t>(i)];
    for (int p = 0; p < 5; ++p) powers(i, p) = std::pow(s, p);
  }
  const Eigen::VectorXd waves = height - powers * powers.householderQr().solve(height);
  Undulation found{.amplitude_A = std::sqrt(2 * waves.squaredNorm() / static_cast<double>(n)), .wavelength_A = 0};
  double strongest = 0;
  for (int half_waves = 4; half_waves <= n / 2; ++half_waves) {
    std::complex<double> sum = 0;
    for (Eigen::Index i = 0; i < n; ++i)
      sum += waves[i] *
             std::polar(1.0, std::numbers::pi * half_waves * (place_A[static_cast<std::size_t>(i)] - first) / length);
    if (std::abs(sum) <= strongest) continue;
    strongest = std::abs(sum);
    found.wavelength_A = 2 * length / half_waves;
  }
  return found;
}

}  // namespace validate
