// Mooney–Rivlin and neo-Hookean in plane stress, compressible or not: the rubber-like laws that Gil et al.
// 2010 name as the way to a better response at large strain.
#pragma once

#include <vector>

#include "membrane/laws/form.hpp"
#include "membrane/laws/isotropic.hpp"

namespace membrane {

/// The 3-D energy µ1/2 (I1 − 3) + µ2/2 (I2 − 3) − (µ1 + 2 µ2) ln J + Λ/2 (ln J)², with I1, I2 the invariants
/// of C = FᵀF (Bonet & Wood, Nonlinear Continuum Mechanics for Finite Element Analysis, ch. 6, for µ2 = 0).
/// At small strain µ1 + µ2 = E/(2 (1 + nu)) and Λ + 2 µ2 is Lamé's constant. Plane stress frees lambda3 and
/// leaves, in A = tr C and L = ln(lambda1 lambda2), the reduced energy whose derivatives at fixed lambda3 are
/// its own. nu = ½ is the incompressible law, reached without a limit: no formula divides by 1 − 2 nu.
struct MooneyRivlin {
  double sheet_modulus_eV_per_A2 = 0;  ///< E·h
  double nu = 0;                       ///< Poisson ratio, in (−1, ½]
  double second_share = 0;             ///< µ2 / (µ1 + µ2), in [0, 1]; 0: neo-Hookean

  /// ln lambda3 from lambda3 dW/dlambda3 = (µ1 + µ2 A) lambda3² − (µ1 + 2 µ2) + Λ ln J = 0 times (1 − 2
  /// nu)/µ, which is convex in ln lambda3: Newton's second iterate is above the root, and all later ones fall
  /// to it. I = tr E, log_area = L. NaN where nothing balances (nu < 0, strong compression).
  double log_thickness(double I, double log_area) const;

  InvariantEnergy energy(double I, double q) const;

  Response operator()(const Voigt& strain) const;
  double natural_width(double axial_strain) const;
  UniaxialResponse uniaxial(double axial_strain) const;
  double thickness_stretch(const Voigt& strain) const;

  void check() const;

  static std::vector<LawForm<MooneyRivlin>> forms();
  static std::vector<LawExample<MooneyRivlin>> examples();
};

static_assert(IsotropicLaw<MooneyRivlin> && ListedLaw<MooneyRivlin>);

/// S = µ (1 − lambda3² C⁻¹).
inline MooneyRivlin neo_hookean(double sheet_modulus_eV_per_A2, double nu) { return {sheet_modulus_eV_per_A2, nu, 0}; }

}  // namespace membrane
