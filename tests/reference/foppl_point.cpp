#include "reference/foppl_point.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "reference/shooting.hpp"

namespace reference {

namespace {

using std::numbers::pi;

// [g − 1, g', ∫ e^(2x/3)/g dx] at x = end, in units of g0 = E·h = 1, hence V = 4/3; g − 1 = departure at x =
// 0.
std::array<double, 3> leave_saddle(double departure, double end, int steps) {
  // Before x = 0: g = 1 + departure e^(4x/3), so 1/g integrates to 3/2 − departure/2.
  std::array<double, 3> y{departure, 4 * departure / 3, 1.5 - departure / 2};
  const bool finite = integrate(
      [](double x, std::span<const double> at, std::span<double> slope) {
        const double eta = at[0], g = 1 + eta;
        slope[0] = at[1];
        slope[1] = -2 * at[1] / 3 + 8 * (eta + eta * (2 + eta) / (g * g)) / 9;  // 8/9 (g − 1/g²)
        slope[2] = std::exp(2 * x / 3) / g;
      },
      0, end, steps, y);
  if (!finite) throw std::runtime_error("the curve of point loads was left");
  return y;
}

}  // namespace

PointLoad foppl_point(double nu, int steps) {
  const double departure = std::copysign(1e-8, nu - 1.0 / 3);
  const auto rim_condition = [&](double end) {  // psi' − nu psi, per r^(1/3)
    const auto y = leave_saddle(departure, end, steps);
    return (y[1] + (1.0 / 3 - nu) * (1 + y[0])) * std::copysign(1, departure);
  };
  double end = 0;
  if (std::abs(nu - 1.0 / 3) > 1e-7) {
    end = 1;
    while (end < 100 && rim_condition(end) < 0) end += 0.5;
    end = root(rim_condition, end - 0.5, end);
  }
  const auto y = leave_saddle(end > 0 ? departure : 0, end, end > 0 ? steps : 0);
  const double V = 4.0 / 3, rim_force = 1 + y[0];  // in the radius r = e^(x − end), rim at 1
  const double depth = V * y[2] * std::exp(-2 * end / 3);
  PointLoad load{};
  load.rim_force = rim_force / (depth * depth);
  load.alpha = 2 * pi * V / (depth * depth * depth);
  load.beta = 4 * (1 - nu) * load.rim_force;
  return load;
}

}  // namespace reference
