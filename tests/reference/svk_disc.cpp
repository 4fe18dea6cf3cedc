#include "reference/svk_disc.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "reference/shooting.hpp"

namespace reference {

namespace {

using std::numbers::pi;

// Hoop stretch − 1, H/R, drop s below the centre, ∫ s R dR over the loaded disc, energy.
using State = std::array<double, 5>;

// Nothing where the sheet gets vertical on the way: a centre too slack for the load.
std::optional<State> shoot(const SvkDisc& disc, double force, double centre_force, int steps) {
  const double c = disc.load_radius, start = 1e-6 * c;
  const auto slopes_under = [&](bool loaded) {
    return [=, &disc](double x, std::span<const double> y, std::span<double> slope) {
      const double R = std::exp(x), q = y[0], t = y[1] > 0 ? y[1] : NAN;
      const double v = force / (2 * pi) * (loaded ? R / (c * c) : 1 / R);  // V/R
      const double tension = std::hypot(t, v);
      const SvkPoint at = svk_point(disc.sheet, tension, 1 + q);
      slope[0] = at.stretch * t / tension - 1 - q;
      slope[1] = at.hoop_force - t;
      slope[2] = R * at.stretch * v / tension;
      slope[3] = loaded ? R * R * y[2] : 0;
      slope[4] = 2 * pi * R * R * at.energy;
    };
  };
  const double stretch = svk_equibiaxial_stretch(disc.sheet, centre_force);
  State y{stretch - 1, stretch * centre_force, 0, 0, 0};
  if (!integrate(slopes_under(true), std::log(start), std::log(c), steps, y)) return {};
  if (c < disc.radius && !integrate(slopes_under(false), std::log(c), std::log(disc.radius), steps, y)) return {};
  return y;
}

}  // namespace

SvkDiscState svk_disc_at_force(const SvkDisc& disc, double force, int steps) {
  const double a = disc.radius, c = disc.load_radius, modulus = disc.sheet.modulus;
  const double centre_force = positive_root(
      [&](double n) {
        const auto y = shoot(disc, force, n, steps);
        return y ? (*y)[0] : -n / modulus;  // a failure counts as much as a strain
      },
      disc.sheet.pretension + std::cbrt(modulus * force * force / (c * c)) / 4);
  const State y = shoot(disc, force, centre_force, steps).value();
  const double tension = std::hypot(y[1], force / (2 * pi * a));
  SvkDiscState state{};
  state.force = force;
  state.centre_depth = y[2];
  state.conjugate_depth = y[2] - 2 * y[3] / (c * c);
  state.rim_force = tension / svk_point(disc.sheet, tension, 1).stretch;
  state.energy = y[4];
  return state;
}

SvkDiscState svk_disc_at_depth(const SvkDisc& disc, double centre_depth, int steps) {
  const double a = disc.radius, delta = centre_depth;
  const double guess = pi * disc.sheet.pretension * delta +
                       disc.sheet.modulus * delta * delta * delta / (a * a);  // about Eq. 16 of Gil et al.
  const auto depth_error = [&](double force) {
    return std::log(svk_disc_at_force(disc, force, steps).centre_depth / delta);
  };
  return svk_disc_at_force(disc, positive_root(depth_error, guess), steps);
}

}  // namespace reference
