// The response that a lattice itself has under homogeneous strain (Cauchy–Born), as coefficients fitted to
// it.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "membrane/laws/isotropic.hpp"
#include "membrane/refusal.hpp"

namespace membrane {

/// c I^a q^b.
struct InvariantTerm {
  int a = 0;
  int b = 0;
  double coefficient_eV_per_A2 = 0;
};

/// W = ¼ (C11 + C12) I² + (C11 − C12) q² + Σ c_ab I^a q^b with a + b ≥ 3 and b ≠ 1. Odd powers of q belong to
/// it: bond-order potentials have knots at the undeformed angles. It holds as far as the states that it was
/// fitted to and is a polynomial beyond.
struct CauchyBorn {
  double sheet_modulus_eV_per_A2 = 0;  ///< E·h = C11 − C12²/C11
  double nu = 0;                       ///< C12 / C11, in (−1, 1)
  std::vector<InvariantTerm> terms;

  static constexpr int highest_degree = 8;

  InvariantEnergy energy(double I, double q) const {
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

  Response operator()(const Voigt& strain) const { return isotropic_response(*this, strain); }
  double natural_width(double axial_strain) const { return solve_natural_width(*this, axial_strain); }
  UniaxialResponse uniaxial(double axial_strain) const { return uniaxial_response(*this, axial_strain); }

  /// A sheet of one atom's thickness has no 3-D parent.
  double thickness_stretch(const Voigt&) const { return 1; }

  void check() const {
    if (!(sheet_modulus_eV_per_A2 > 0) || !std::isfinite(sheet_modulus_eV_per_A2))
      refuse("law.sheet_modulus_eV_per_A2", sheet_modulus_eV_per_A2, "must be positive and finite");
    if (!(nu > -1 && nu < 1)) refuse("law.nu", nu, "must lie between -1 and 1, both excluded");
    for (const auto& [a, b, c] : terms) {
      if (a < 0 || b < 0 || a + b < 3 || a + b > highest_degree)
        refuse("law.terms", a + b,
               "the degree a + b of a term must lie between 3 and 8, a and b not negative");
      if (b == 1)
        refuse("law.terms", b, "no term may be linear in q: the sheet at rest would have no stress zero");
      if (!std::isfinite(c)) refuse("law.terms", c, "every coefficient must be finite");
    }
  }
};

static_assert(IsotropicLaw<CauchyBorn>);

}  // namespace membrane
