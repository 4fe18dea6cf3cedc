#include "membrane/laws/cauchy_born.hpp"

#include <array>
#include <cmath>

#include "membrane/base/refusal.hpp"

namespace membrane {

InvariantEnergy CauchyBorn::energy(double I, double q) const {
  std::array<double, highest_degree + 1> I_to, q_to;
  I_to[0] = q_to[0] = 1;
  for (int n = 1; n <= highest_degree; ++n) {
    I_to[n] = I * I_to[n - 1];
    q_to[n] = q * q_to[n - 1];
  }
  InvariantEnergy at = quadratic_energy(sheet_modulus_eV_per_A2, nu, I, q);
  for (const auto& [a, b, c] : terms) {
    at.W += c * I_to[a] * q_to[b];
    if (a > 0) at.W_I += c * a * I_to[a - 1] * q_to[b];
    if (a > 1) at.W_II += c * a * (a - 1) * I_to[a - 2] * q_to[b];
    if (b == 0) continue;
    at.W_q_over_q += c * b * I_to[a] * q_to[b - 2];
    at.W_qq += c * b * (b - 1) * I_to[a] * q_to[b - 2];
    if (a > 0) at.W_Iq += c * a * b * I_to[a - 1] * q_to[b - 1];
  }
  return at;
}

Response CauchyBorn::operator()(const Voigt& strain) const { return isotropic_response(*this, strain); }

double CauchyBorn::natural_width(double axial_strain) const { return solve_natural_width(*this, axial_strain); }

UniaxialResponse CauchyBorn::uniaxial(double axial_strain) const { return uniaxial_response(*this, axial_strain); }

void CauchyBorn::check() const {
  if (!(sheet_modulus_eV_per_A2 > 0) || !std::isfinite(sheet_modulus_eV_per_A2))
    refuse("law.sheet_modulus_eV_per_A2", sheet_modulus_eV_per_A2, "must be positive and finite");
  if (!(nu > -1 && nu < 1)) refuse("law.nu", nu, "must lie between -1 and 1, both excluded");
  for (const auto& [a, b, c] : terms) {
    if (a < 0 || b < 0 || a + b < 3 || a + b > highest_degree)
      refuse("law.terms", a + b, "the degree a + b of a term must lie between 3 and 8, a and b not negative");
    if (b == 1) refuse("law.terms", b, "no term may be linear in q: the sheet at rest would have no stress zero");
    if (!std::isfinite(c)) refuse("law.terms", c, "every coefficient must be finite");
  }
}

std::vector<LawForm<CauchyBorn>> CauchyBorn::forms() { return {}; }

/// Like one fitted to a potential: AIREBO's constants, every kind of term, odd powers of q with them.
std::vector<LawExample<CauchyBorn>> CauchyBorn::examples() {
  return {{with_nu("Cauchy-Born", 0.3645),
           {17.33,
            0.3645,
            {{3, 0, -14.0},
             {1, 2, -30.0},
             {0, 3, 25.0},
             {4, 0, 5.0},
             {2, 2, 20.0},
             {1, 3, -35.0},
             {0, 4, -40.0},
             {2, 3, 11.0},
             {3, 2, -17.0},
             {0, 5, 60.0},
             {1, 5, 30.0},
             {6, 0, 3.0}}}}};
}

}  // namespace membrane
