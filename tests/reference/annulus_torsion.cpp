#include "reference/annulus_torsion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "reference/shooting.hpp"

namespace reference {

namespace {

using std::numbers::pi;

// Radial displacement, r N_rr, turn v/r, in units of a = E·h = 1 under the torque 2π.
using State = std::array<double, 3>;

State shoot(double b, double hub_pull, int steps, double& largest_nu) {
  const auto slopes = [&](double r, std::span<const double> y, std::span<double> slope) {
    const double N_rr = y[1] / r, N_rt = 1 / (r * r);
    const double tangent = N_rt / N_rr, cos2 = 1 / (1 + tangent * tangent), sin2 = 1 - cos2;
    const double E1 = N_rr / cos2;
    const double E2 = (y[0] / r - E1 * sin2) / cos2;  // hoop strain = E1 sin² + E2 cos²
    slope[0] = E1 * cos2 + E2 * sin2;
    slope[1] = E1 * sin2;
    slope[2] = 2 * (E1 - E2) * tangent * cos2 / r;
    largest_nu = std::min(largest_nu, -E2 / E1);
  };
  State y{0, hub_pull, 0};
  if (!integrate(slopes, 1, b, steps, y)) throw std::runtime_error("the annulus has no such state");
  return y;
}

}  // namespace

AnnulusTorsion annulus_torsion(double rim_over_hub) {
  const double B = rim_over_hub * rim_over_hub;
  const auto logarithm = [B](double s) { return std::log((B - s) / (1 - s)); };  // s = (c/a)²
  const double s = root([&](double x) { return logarithm(x) - x / (1 - x) + x / (B - x); }, 1e-9, 1 - 1e-9);
  return {4 * pi * s / logarithm(s), std::sqrt(s), s / (B - s)};
}

AnnulusTorsion annulus_torsion_by_shooting(double rim_over_hub, int steps) {
  double largest_nu = 0;
  const double hub_pull =
      positive_root([&](double pull) { return shoot(rim_over_hub, pull, steps, largest_nu)[0]; }, 0.5);
  largest_nu = 1;
  const State rim = shoot(rim_over_hub, hub_pull, steps, largest_nu);
  return {2 * pi / rim[2], 1 / std::hypot(1, hub_pull), largest_nu};
}

}  // namespace reference
