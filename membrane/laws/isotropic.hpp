// What every isotropic law shares once its energy is known in two invariants of E: the tensors S and dS/dE,
// and the natural width where it has no closed form.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "membrane/laws/principal.hpp"
#include "membrane/laws/response.hpp"

namespace membrane {

/// Energy per reference area (eV/Å²) as W(I, q) and its derivatives. I = tr E = E1 + E2; q² = ½ dev E : dev
/// E, so that q = |E1 − E2| / 2. Regular where W_q / q is, odd powers of q from the third on included.
struct InvariantEnergy {
  double W = 0;
  double W_I = 0, W_q_over_q = 0;
  double W_II = 0, W_Iq = 0, W_qq = 0;
};

/// An isotropic law given by its energy alone.
template <class L>
concept InvariantLaw = requires(const L& law, double I, double q) {
  { law.nu } -> std::convertible_to<double>;
  { law.energy(I, q) } -> std::same_as<InvariantEnergy>;
};

/// St Venant–Kirchhoff's ¼ (C11 + C12) I² + (C11 − C12) q², C11 = E·h / (1 − nu²), C12 = nu C11: the part of
/// second order of any law.
inline InvariantEnergy quadratic_energy(double sheet_modulus, double nu, double I, double q) {
  const double area = 0.5 * sheet_modulus / (1 - nu);
  const double shear = 2 * sheet_modulus / (1 + nu);
  return {0.5 * (area * I * I + shear * q * q), area * I, shear, area, 0, shear};
}

/// S = W_I 1 + ½ W_q n and dS/dE = W_II 1⊗1 + ½ W_Iq (1⊗n + n⊗1) + ¼ W_qq n⊗n + W_q/(4 q) m⊗m, with
/// n = dev E / q = M1⊗M1 − M2⊗M2 and m = M1⊗M2 + M2⊗M1.
Response isotropic_response(const InvariantEnergy& energy, const Principal& strain);

template <InvariantLaw L>
Response isotropic_response(const L& law, const Voigt& strain) {
  const Principal at = principal_strains(strain);
  return isotropic_response(law.energy(strain[0] + strain[1], 0.5 * (at.larger - at.smaller)), at);
}

/// Principal forces at principal strains E1 ≥ E2, and their derivatives.
struct PrincipalResponse {
  double W, S1, S2;
  double K11, K12, K22;

  PrincipalResponse(const InvariantEnergy& energy, double q)
      : W(energy.W),
        S1(energy.W_I + 0.5 * q * energy.W_q_over_q),
        S2(energy.W_I - 0.5 * q * energy.W_q_over_q),
        K11(energy.W_II + energy.W_Iq + 0.25 * energy.W_qq),
        K12(energy.W_II - 0.25 * energy.W_qq),
        K22(energy.W_II - energy.W_Iq + 0.25 * energy.W_qq) {}
};

template <InvariantLaw L>
PrincipalResponse principal_response(const L& law, double larger, double smaller) {
  const double q = 0.5 * (larger - smaller);
  return {law.energy(larger + smaller, q), q};
}

/// The strain E2 at which S2(E1, E2) = 0, to rounding, for E1 > 0. NaN where the law has none within reach.
template <InvariantLaw L>
double solve_natural_width(const L& law, double axial_strain) {
  constexpr int most_iterations = 60;
  constexpr double nothing = -0.5;  // strain of a width of zero
  constexpr double last = 1e-8;     // of the strain: what Newton leaves after this is its square
  constexpr double noise = 1e-15;   // of forces of order one, in strain
  double width = std::max(-law.nu * axial_strain, 0.9 * nothing);
  for (int i = 0; i < most_iterations; ++i) {
    const PrincipalResponse at = principal_response(law, axial_strain, width);
    if (!(at.K22 > 0)) break;
    const double step = -at.S2 / at.K22;
    if (std::abs(step) <= last * axial_strain + noise) return width + step;
    width = std::max(width + step, 0.5 * (width + nothing));
  }
  return std::numeric_limits<double>::quiet_NaN();
}

/// Energy, force and tangent along the natural width: dS1/dE1 = K11 − K12² / K22.
template <InvariantLaw L>
UniaxialResponse uniaxial_response(const L& law, double axial_strain) {
  const PrincipalResponse at = principal_response(law, axial_strain, law.natural_width(axial_strain));
  return {at.W, at.S1, at.K11 - at.K12 * at.K12 / at.K22};
}

}  // namespace membrane
