#include "reference/hencky.hpp"

#include <cmath>
#include <vector>

#include "reference/shooting.hpp"

namespace reference {

namespace {

std::vector<double> coefficients(double b0, int terms) {
  std::vector<double> b{b0}, square{b0 * b0};
  for (int m = 0; m + 1 < terms; ++m) {
    double sum = m == 0 ? -1.0 / 8 : 0;
    for (int j = 0; j < m; ++j) sum -= square[m - j] * 4 * (j + 1) * (j + 2) * b[j + 1];
    b.push_back(sum / (square[0] * 4 * (m + 1) * (m + 2)));
    square.push_back(0);
    for (int i = 0; i <= m + 1; ++i) square.back() += b[i] * b[m + 1 - i];
  }
  return b;
}

// ½ ∫ rho/n drho over the unit radius: 1/n as a series too.
double height(const std::vector<double>& b) {
  std::vector<double> inverse{1 / b[0]};
  double sum = inverse[0] / 4;
  for (std::size_t m = 1; m < b.size(); ++m) {
    double next = 0;
    for (std::size_t i = 1; i <= m; ++i) next -= b[i] * inverse[m - i];
    inverse.push_back(next / b[0]);
    sum += inverse[m] / (4 * (static_cast<double>(m) + 1));
  }
  return sum;
}

}  // namespace

Hencky hencky(double nu, int terms) {
  const auto rim_condition = [&](double b0) {
    const std::vector<double> b = coefficients(b0, terms);
    double sum = 0;
    for (std::size_t k = 0; k < b.size(); ++k) sum += b[k] * (2 * static_cast<double>(k) + 1 - nu);
    return sum;
  };
  const double b0 = root(rim_condition, 0.3, 2);  // 0.43 at nu = 0.3
  return {height(coefficients(b0, terms)), b0};
}

}  // namespace reference
