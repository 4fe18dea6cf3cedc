#include "reference/svk_sphere.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "reference/shooting.hpp"

namespace reference {

namespace {

using std::numbers::pi;

struct Shot {
  double hoop_excess;  // r/a − 1 at the rim, to vanish; +1 where the sheet reaches the sphere's equator
  SvkSphereState state;
};

// On the sphere: φ/R, T1, drop below the centre, energy.
using Contact = std::array<double, 4>;
// Outside: hoop stretch − 1, H/R, drop, energy.
using Free = std::array<double, 4>;

bool integrate_contact(const SvkSphere& sphere, double b, int steps, Contact& y, double& least_pressure) {
  const auto slopes = [&](double x, std::span<const double> at_x, std::span<double> slope) {
    const double R = std::exp(x), phi = std::min(at_x[0] * R, pi / 2), T1 = at_x[1] > 0 ? at_x[1] : NAN;
    const double hoop_stretch = sphere.tip_radius * std::sin(phi) / R;
    const SvkPoint at = svk_point(sphere.sheet, T1, hoop_stretch);
    slope[0] = at.stretch / sphere.tip_radius - at_x[0];
    slope[1] = at.hoop_force * std::cos(phi) - T1;
    slope[2] = R * at.stretch * std::sin(phi);
    slope[3] = 2 * pi * R * R * at.energy;
    // Both curvatures are 1/Rt: pressure = (Cauchy forces T1/λ2 + T2/λ1) / Rt.
    least_pressure = std::min(least_pressure, (T1 / hoop_stretch + at.hoop_force / at.stretch) / sphere.tip_radius);
  };
  return integrate(slopes, std::log(1e-6 * b), std::log(b), steps, y);
}

bool integrate_free(const SvkSphere& sphere, double force, double b, int steps, Free& y) {
  const auto slopes = [&](double x, std::span<const double> at_x, std::span<double> slope) {
    const double R = std::exp(x), q = at_x[0], t = at_x[1] > 0 ? at_x[1] : NAN, v = force / (2 * pi * R);
    const double tension = std::hypot(t, v);
    const SvkPoint at = svk_point(sphere.sheet, tension, 1 + q);
    slope[0] = at.stretch * t / tension - 1 - q;
    slope[1] = at.hoop_force - t;
    slope[2] = R * at.stretch * v / tension;
    slope[3] = 2 * pi * R * R * at.energy;
  };
  return integrate(slopes, std::log(b), std::log(sphere.radius), steps, y);
}

// Nothing where the meridian loses its tension on the way: a centre too slack for this contact.
std::optional<Shot> shoot(const SvkSphere& sphere, double b, double centre_force, int steps) {
  const double a = sphere.radius, Rt = sphere.tip_radius;
  const double stretch = svk_equibiaxial_stretch(sphere.sheet, centre_force);
  Contact on{stretch / Rt, stretch * centre_force, 0, 0};
  double least_pressure = INFINITY;
  if (!integrate_contact(sphere, b, steps, on, least_pressure)) return {};
  if (on[0] * b >= pi / 2) return Shot{1, {}};

  const double phi = on[0] * b, force = 2 * pi * b * on[1] * std::sin(phi);
  Free off{Rt * std::sin(phi) / b - 1, on[1] * std::cos(phi), on[2], on[3]};
  if (!integrate_free(sphere, force, b, steps, off)) return {};
  const double tension = std::hypot(off[1], force / (2 * pi * a));
  const double rim_force = tension / svk_point(sphere.sheet, tension, 1).stretch;
  return Shot{off[0], {b, force, off[2], rim_force, off[3], least_pressure}};
}

}  // namespace

SvkSphereState svk_sphere_at_contact(const SvkSphere& sphere, double contact_radius, int steps) {
  const double b = contact_radius, slope = b / sphere.tip_radius;
  const double centre_force = positive_root(
      [&](double n) {
        const auto shot = shoot(sphere, b, n, steps);
        return shot ? shot->hoop_excess : -n / sphere.sheet.modulus;
      },
      sphere.sheet.pretension + sphere.sheet.modulus * slope * slope / 4);
  return shoot(sphere, b, centre_force, steps).value().state;
}

SvkSphereState svk_sphere_at_depth(const SvkSphere& sphere, double depth, int steps) {
  const auto depth_error = [&](double b) { return std::log(svk_sphere_at_contact(sphere, b, steps).depth / depth); };
  // From below, in small steps: no equilibrium lies on a contact much too wide.
  double b = std::min(std::sqrt(sphere.tip_radius * depth), sphere.tip_radius) / 4;
  while (b > 1e-9 * sphere.radius && depth_error(b) > 0) b /= 2;
  while (b < sphere.radius && depth_error(1.1 * b) < 0) b *= 1.1;
  return svk_sphere_at_contact(sphere, root(depth_error, b, 1.1 * b), steps);
}

}  // namespace reference
