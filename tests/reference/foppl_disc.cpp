#include "reference/foppl_disc.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "reference/shooting.hpp"

namespace reference {

namespace {

// N_r, N_θ, drop s below the centre, ∫ s r dr over the loaded disc.
using State = std::array<double, 4>;

// Nothing where N_r vanishes on the way: a centre too slack for the load.
std::optional<State> shoot(const FopplDisc& disc, double force, double centre_force, int steps) {
  const double c = disc.load_radius, start = 1e-6 * c;
  const auto slopes_under = [&](bool loaded) {
    return [=](double x, std::span<const double> y, std::span<double> slope) {
      const double r = std::exp(x), N_r = y[0] > 0 ? y[0] : NAN, N_hoop = y[1];
      const double steepness = force / (2 * std::numbers::pi) * (loaded ? r / (c * c) : 1 / r) / N_r;
      slope[0] = N_hoop - N_r;
      slope[1] = N_r - N_hoop - steepness * steepness / 2;
      slope[2] = r * steepness;
      slope[3] = loaded ? r * r * y[2] : 0;
    };
  };
  State y{centre_force, centre_force, 0, 0};
  if (!integrate(slopes_under(true), std::log(start), std::log(c), steps, y)) return {};
  if (c < 1 && !integrate(slopes_under(false), std::log(c), 0, steps, y)) return {};
  return y;
}

}  // namespace

FopplDepth foppl_disc(const FopplDisc& disc, double force, int steps) {
  const double c = disc.load_radius, nu = disc.nu;
  const double centre_force = positive_root(
      [&](double n) {
        const auto y = shoot(disc, force, n, steps);
        return y ? (*y)[1] - nu * (*y)[0] - (1 - nu) * disc.pretension : -n;
      },
      disc.pretension + std::cbrt(force * force / (c * c)) / 4);
  const State y = shoot(disc, force, centre_force, steps).value();
  return {y[2], y[2] - 2 * y[3] / (c * c), y[0]};
}

}  // namespace reference
