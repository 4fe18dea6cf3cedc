#include "membrane/laws/cauchy_born_sixfold.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "membrane/base/refusal.hpp"
#include "membrane/laws/cauchy_born.hpp"
#include "membrane/laws/principal.hpp"

namespace membrane {
namespace {

/// A function of the doubled angle 2θ with its derivatives by it.
struct AngularFunction {
  double value = 0, first = 0, second = 0;
};

AngularFunction angular_function(Sixfold kind, double cosine, double sine) {
  switch (kind) {
    case Sixfold::none:
      return {1, 0, 0};
    case Sixfold::cosine:
    case Sixfold::cosine_squared: {
      const double c = cosine * (4 * cosine * cosine - 3), s = sine * (3 - 4 * sine * sine);  // of 3 × 2θ
      if (kind == Sixfold::cosine) return {c, -3 * s, -9 * c};
      return {c * c, -6 * c * s, 18 * (s * s - c * c)};
    }
    case Sixfold::knots:
      break;
  }
  AngularFunction sum;
  for (int k = 0; k < 3; ++k) {
    const double turn_c = k == 0 ? 1 : -0.5, turn_s = (k == 0 ? 0 : k == 1 ? 0.5 : -0.5) * std::numbers::sqrt3;
    const double c = cosine * turn_c - sine * turn_s, s = sine * turn_c + cosine * turn_s;
    sum.value += std::abs(c) * c * c;
    sum.first -= 3 * std::abs(c) * c * s;
    sum.second += std::abs(c) * (6 * s * s - 3 * c * c);
  }
  return sum;
}

/// Derivatives by I, by d along itself (n) and across (m).
struct Polar {
  double W = 0, I = 0, n = 0, m = 0, II = 0, In = 0, Im = 0, nn = 0, nm = 0, mm = 0;
};

/// Of q^b f(φ), φ the argument of d: b q^{b−1} f along and q^{b−1} f' across; second b (b − 1) q^{b−2} f,
/// (b − 1) q^{b−2} f' and q^{b−2} (b f + f'').
Polar derivatives(const CauchyBornSixfold& law, double I, double q, double cosine, double sine) {
  constexpr int highest = CauchyBornSixfold::highest_degree;
  std::array<double, highest + 1> I_to, q_to;
  I_to[0] = q_to[0] = 1;
  for (int n = 1; n <= highest; ++n) {
    I_to[n] = I * I_to[n - 1];
    q_to[n] = q * q_to[n - 1];
  }
  const double area = 0.5 * law.sheet_modulus_eV_per_A2 / (1 - law.nu);
  const double shear = 2 * law.sheet_modulus_eV_per_A2 / (1 + law.nu);
  Polar sum{0.5 * (area * I * I + shear * q * q), area * I, shear * q, 0, area, 0, 0, shear, 0, shear};
  for (const auto& [a, b, angle, c] : law.terms) {
    const AngularFunction f = angular_function(angle, cosine, sine);
    const double I0 = c * I_to[a], I1 = a > 0 ? c * a * I_to[a - 1] : 0, I2 = a > 1 ? c * a * (a - 1) * I_to[a - 2] : 0;
    sum.W += I0 * q_to[b] * f.value;
    sum.I += I1 * q_to[b] * f.value;
    sum.II += I2 * q_to[b] * f.value;
    if (b == 0) continue;
    sum.n += I0 * b * q_to[b - 1] * f.value;
    sum.m += I0 * q_to[b - 1] * f.first;
    sum.In += I1 * b * q_to[b - 1] * f.value;
    sum.Im += I1 * q_to[b - 1] * f.first;
    sum.nn += I0 * b * (b - 1) * q_to[b - 2] * f.value;
    sum.nm += I0 * (b - 1) * q_to[b - 2] * f.first;
    sum.mm += I0 * q_to[b - 2] * (b * f.value + f.second);
  }
  return sum;
}

}  // namespace

/// In the variables I and d, d along its own direction and across it.
Response CauchyBornSixfold::operator()(const Voigt& strain) const {
  const Principal at = principal_strains(strain);
  const double I = strain[0] + strain[1], q = 0.5 * (at.larger - at.smaller);
  const double zc = std::cos(2 * zigzag_rad), zs = std::sin(2 * zigzag_rad);
  const double c = at.cos_2theta * zc + at.sin_2theta * zs, s = at.sin_2theta * zc - at.cos_2theta * zs;
  const Polar polar = derivatives(*this, I, q, c, s);

  const Voigt one(1, 1, 0);
  const Voigt n = 0.5 * Voigt(at.cos_2theta, -at.cos_2theta, at.sin_2theta);  // dq/dE
  const Voigt m = 0.5 * Voigt(-at.sin_2theta, at.sin_2theta, at.cos_2theta);  // across
  const auto both = [](const Voigt& a, const Voigt& b) -> Eigen::Matrix3d {
    return a * b.transpose() + b * a.transpose();
  };
  Response response;
  response.energy_eV_per_A2 = polar.W;
  response.force_eV_per_A2 = polar.I * one + polar.n * n + polar.m * m;
  response.tangent_eV_per_A2 = polar.II * one * one.transpose() + polar.nn * n * n.transpose() +
                               polar.mm * m * m.transpose() + polar.In * both(one, n) + polar.Im * both(one, m) +
                               polar.nm * both(n, m);
  return response;
}

/// Newton's method on the force across, to rounding.
double CauchyBornSixfold::natural_width(double axial_strain) const {
  constexpr int most_iterations = 60;
  CauchyBornSixfold along_x = *this;
  along_x.zigzag_rad = 0;
  double width = -nu * axial_strain;
  for (int i = 0; i < most_iterations; ++i) {
    const Response at = along_x(Voigt(axial_strain, width, 0));
    if (!(at.tangent_eV_per_A2(1, 1) > 0)) break;
    const double step = -at.force_eV_per_A2[1] / at.tangent_eV_per_A2(1, 1);
    width += step;
    if (std::abs(step) <= 1e-8 * std::abs(axial_strain) + 1e-15) return width;
  }
  return std::nan("");
}

void CauchyBornSixfold::check() const {
  if (!(sheet_modulus_eV_per_A2 > 0) || !std::isfinite(sheet_modulus_eV_per_A2))
    refuse("law.sheet_modulus_eV_per_A2", sheet_modulus_eV_per_A2, "must be positive and finite");
  if (!(nu > -1 && nu < 1)) refuse("law.nu", nu, "must lie between -1 and 1, both excluded");
  if (!std::isfinite(zigzag_rad)) refuse("law.zigzag_rad", zigzag_rad, "must be finite");
  for (const auto& [a, b, angle, c] : terms) {
    if (a < 0 || b < 0 || a + b < 3 || a + b > highest_degree)
      refuse("law.terms", a + b, "the degree a + b of a term must lie between 3 and 8, a and b not negative");
    if (b == 1) refuse("law.terms", b, "no term may be linear in q: the sheet at rest would have no stress zero");
    if (angle != Sixfold::none && b < 3)
      refuse("law.terms", b,
             "a term with an angle needs b of 3 or more: a hexagonal lattice is isotropic to second order");
    if (!std::isfinite(c)) refuse("law.terms", c, "every coefficient must be finite");
  }
}

std::vector<LawForm<CauchyBornSixfold>> CauchyBornSixfold::forms() { return {}; }

/// The isotropic example with directions.
std::vector<LawExample<CauchyBornSixfold>> CauchyBornSixfold::examples() {
  const CauchyBorn isotropic = CauchyBorn::examples().front().law;
  CauchyBornSixfold law{isotropic.sheet_modulus_eV_per_A2, isotropic.nu, 0, {}};
  for (const auto& [a, b, c] : isotropic.terms) law.terms.push_back({a, b, Sixfold::none, c});
  law.terms.push_back({0, 3, Sixfold::cosine, 20});
  law.terms.push_back({0, 3, Sixfold::knots, 15});
  law.terms.push_back({1, 3, Sixfold::cosine, -30});
  law.terms.push_back({0, 4, Sixfold::cosine, 10});
  law.terms.push_back({1, 3, Sixfold::knots, 8});
  law.terms.push_back({0, 6, Sixfold::cosine_squared, -25});
  return {{with_nu("Cauchy-Born sixfold", law.nu), law}};
}

}  // namespace membrane
