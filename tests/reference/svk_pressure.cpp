#include "reference/svk_pressure.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "reference/shooting.hpp"

namespace reference {

namespace {

using std::numbers::pi;

// Hoop stretch − 1, H/R, drop below the centre, volume below the sheet's height at the centre, energy.
using State = std::array<double, 5>;

// Nothing where the sheet turns over towards the axis: a centre too slack for the pressure.
std::optional<State> shoot(const SvkSheet& sheet, double a, double pressure, double centre_force, int steps) {
  const auto slopes = [&](double x, std::span<const double> y, std::span<double> slope) {
    const double R = std::exp(x), hoop_stretch = y[0] > -1 ? 1 + y[0] : NAN, t = y[1];
    const double v = pressure * hoop_stretch * hoop_stretch * R / 2;
    const double tension = std::hypot(t, v), sine = v / tension;
    const SvkPoint at = svk_point(sheet, tension, hoop_stretch);
    slope[0] = at.stretch * t / tension - hoop_stretch;
    slope[1] = at.hoop_force - t - pressure * R * hoop_stretch * at.stretch * sine;
    slope[2] = R * at.stretch * sine;
    slope[3] = pi * R * R * hoop_stretch * hoop_stretch * slope[2];
    slope[4] = 2 * pi * R * R * at.energy;
  };
  const double stretch = svk_equibiaxial_stretch(sheet, centre_force);
  State y{stretch - 1, stretch * centre_force, 0, 0, 0};
  if (!integrate(slopes, std::log(1e-6 * a), std::log(a), steps, y)) return {};
  return y;
}

// From the largest force down to the first change of sign: shots with less have folded.
double first_root_from_above(const std::function<double(double)>& f, double high) {
  const double least = 1e-12 * high;
  double low = high / 1.1;
  while (f(low) > 0) {
    if (low < least) throw std::runtime_error("no equilibrium under this pressure");
    high = low;
    low /= 1.1;
  }
  return root(f, low, high);
}

}  // namespace

SvkPressureState svk_pressure(const SvkSheet& sheet, double radius, double pressure, Rim rim, int steps) {
  const auto rim_condition = [&](double n) {
    const auto y = shoot(sheet, radius, pressure, n, steps);
    if (!y) return -n / sheet.modulus;
    return rim == Rim::clamped ? (*y)[0] : (*y)[1] / sheet.modulus;
  };
  const double load = pressure * radius / sheet.modulus;
  const double ample = sheet.pretension + 20 * sheet.modulus * (load + std::pow(load, 2.0 / 3));
  const double centre_force = first_root_from_above(rim_condition, ample);
  const State y = shoot(sheet, radius, pressure, centre_force, steps).value();
  return {y[2], radius * (1 + y[0]), y[3], y[4]};
}

}  // namespace reference
