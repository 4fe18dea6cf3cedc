#include "membrane/meridian/terms.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "membrane/laws/tension_field.hpp"

namespace membrane::meridian {

Voigt Stretching::strain(double s, const LocalState& y) {
  const double hoop = y[U] / s;
  return {y[U1] + 0.5 * (y[U1] * y[U1] + y[W1] * y[W1]), hoop + 0.5 * hoop * hoop, 0};
}

Response Stretching::response(const Voigt& strain) const {
  const Voigt total = strain + Voigt(offset, offset, 0);
  return std::visit([&]<MaterialLaw L>(const L& l) { return relaxed ? tension_field(l, total) : l(total); }, law);
}

SheetState Stretching::state(const Voigt& strain) const {
  const Voigt total = strain + Voigt(offset, offset, 0);
  return std::visit([&]<MaterialLaw L>(const L& l) { return sheet_state(l, total); }, law);
}

Density Stretching::operator()(const Ring& ring, const LocalState& y) const {
  const double s = ring.radius_A;
  const Response at = response(strain(s, y));
  const Voigt& S = at.force_eV_per_A2;
  LocalState radial = LocalState::Zero();  // dE_r/dy
  radial[U1] = 1 + y[U1];
  radial[W1] = y[W1];
  const double hoop = (1 + y[U] / s) / s;  // dE_hoop/du
  const Eigen::Matrix2d D = at.tangent_eV_per_A2.topLeftCorner<2, 2>();
  Density density;
  density.value = at.energy_eV_per_A2 - flat_energy;
  density.gradient = S[0] * radial;
  density.gradient[U] = S[1] * hoop;
  density.hessian = D(0, 0) * radial * radial.transpose();
  density.hessian.col(U) += D(0, 1) * hoop * radial;
  density.hessian.row(U) += D(0, 1) * hoop * radial.transpose();
  density.hessian(U, U) += D(1, 1) * hoop * hoop + S[1] / (s * s);
  density.hessian(U1, U1) += S[0];
  density.hessian(W1, W1) += S[0];
  return density;
}

Density Bending::operator()(const Ring& ring, const LocalState& y) const {
  const double s = ring.radius_A;
  const double p = 1 + y[U1];
  const double t = y[W1];
  const double P = y[U2];
  const double T = y[W2];
  const double rho = s + y[U];
  const double l2 = p * p + t * t;
  const double l = std::sqrt(l2);
  const double i3 = 1 / (l * l2);  // λ⁻³, λ⁻⁵, λ⁻⁷
  const double i5 = i3 / l2;
  const double i7 = i5 / l2;
  const double N = p * T - t * P;
  const double sine = t / l;

  const double curvature = N * i3 + sine / rho;
  LocalState d = LocalState::Zero();
  d[U] = -sine / (rho * rho);
  d[U1] = T * i3 - 3 * p * N * i5 - p * t * i3 / rho;
  d[U2] = -t * i3;
  d[W1] = -P * i3 - 3 * t * N * i5 + p * p * i3 / rho;
  d[W2] = p * i3;

  Eigen::Matrix<double, 6, 6> dd = Eigen::Matrix<double, 6, 6>::Zero();
  const auto set = [&](int a, int b, double value) { dd(a, b) = dd(b, a) = value; };
  set(U, U, 2 * sine / (rho * rho * rho));
  set(U, U1, p * t * i3 / (rho * rho));
  set(U, W1, -p * p * i3 / (rho * rho));
  set(U1, U1, -6 * p * T * i5 - 3 * N * i5 + 15 * p * p * N * i7 + (-t * i3 + 3 * p * p * t * i5) / rho);
  set(U1, W1, -3 * t * T * i5 + 3 * p * P * i5 + 15 * p * t * N * i7 + (2 * p * i3 - 3 * p * p * p * i5) / rho);
  set(W1, W1, 6 * t * P * i5 - 3 * N * i5 + 15 * t * t * N * i7 - 3 * p * p * t * i5 / rho);
  set(U1, U2, 3 * p * t * i5);
  set(U1, W2, i3 - 3 * p * p * i5);
  set(U2, W1, -i3 + 3 * t * t * i5);
  set(W1, W2, -3 * p * t * i5);

  Density density;
  density.value = 0.5 * modulus_eV * curvature * curvature;
  density.gradient = modulus_eV * curvature * d;
  density.hessian = modulus_eV * (d * d.transpose() + curvature * dd);
  return density;
}

Density Pressure::operator()(const Ring& ring, const LocalState& y) const {
  const double s = ring.radius_A;
  const double r = s + y[U];
  const double c = pressure_eV_per_A3 / s;
  Density density;
  density.value = 0.5 * c * r * r * y[W1];
  density.gradient[U] = c * r * y[W1];
  density.gradient[W1] = 0.5 * c * r * r;
  density.hessian(U, U) = c * y[W1];
  density.hessian(U, W1) = density.hessian(W1, U) = c * r;
  return density;
}

/// Below the centre (|x|² − radius²)/(|x| + radius) in x − centre = (r, above + radius): nothing cancels near the tip.
double SphereContact::gap(const Ring& ring, const LocalState& y) const {
  const double r = ring.radius_A + y[U];
  const double above = y[W] - depth_A;
  if (above < -radius_A) return r - radius_A;
  return (r * r + above * (above + 2 * radius_A)) / (std::hypot(r, above + radius_A) + radius_A);
}

LocalState SphereContact::normal(const Ring& ring, const LocalState& y) const {
  const double r = ring.radius_A + y[U];
  const double below_centre = std::max(0.0, y[W] - depth_A + radius_A);
  LocalState n = LocalState::Zero();
  n[U] = r / std::hypot(r, below_centre);
  n[W] = below_centre / std::hypot(r, below_centre);
  return n;
}

Density SphereContact::operator()(const Ring& ring, const LocalState& y) const {
  return (*this)(ring, y, barrier_eV_per_A2 / gap(ring, y));
}

Density SphereContact::operator()(const Ring& ring, const LocalState& y, double pressure) const {
  const double g = gap(ring, y);
  Density density;
  density.value = std::numeric_limits<double>::infinity();
  if (!(g > 0)) return density;
  const LocalState n = normal(ring, y);
  const LocalState across = (LocalState() << n[W], 0, 0, -n[U], 0, 0).finished();
  const double distance = g + radius_A;
  const bool beside_cylinder = n[W] == 0;
  density.value = -barrier_eV_per_A2 * std::log(g / radius_A);
  density.gradient = -barrier_eV_per_A2 / g * n;
  density.hessian = pressure / g * n * n.transpose();
  if (!beside_cylinder) density.hessian -= pressure / distance * across * across.transpose();
  return density;
}

}  // namespace membrane::meridian
