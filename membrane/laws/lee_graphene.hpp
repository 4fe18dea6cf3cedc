// Graphene that softens: Lee, Wei, Kysar & Hone, Science 321 (2008) 385, whose sheet under uniaxial stress
// has S = E·h E + D E² (second Piola–Kirchhoff force, Green–Lagrange strain).
#pragma once

#include <vector>

#include "membrane/laws/form.hpp"
#include "membrane/laws/isotropic.hpp"

namespace membrane {

/// St Venant–Kirchhoff and the isotropic terms of third order, W3 = A I³ + B I q². They are the only two in
/// the plane; the published response fixes them both if the law is to keep it *exactly*, with the natural
/// width E2 = −nu E1 of the linear sheet: dW3/dE2 = 0 there and W3 = D E1³/3, hence
///   A = D (1 − 3 nu) / (12 (1 − nu)³),  B = D / (1 − nu²).
/// With D < 0 the energy is not bounded below, and it is convex only so far: the uniaxial tangent vanishes at
/// E = −E·h / (2 D) (S = −(E·h)²/(4 D), the strength), and at equal biaxial strain the shear stiffness does
/// already at E = −E·h (1 − nu) / (2 D).
struct LeeGraphene {
  double sheet_modulus_eV_per_A2 = 0;                   ///< E·h
  double nu = 0;                                        ///< Poisson ratio, in (−1, 1)
  double third_order_modulus_eV_per_A2 = -43.06641261;  ///< D; −690 N/m in the publication

  InvariantEnergy energy(double I, double q) const;

  Response operator()(const Voigt& strain) const;
  double natural_width(double axial_strain) const { return -nu * axial_strain; }
  UniaxialResponse uniaxial(double axial_strain) const;

  /// A sheet of one atom's thickness has no 3-D parent.
  double thickness_stretch(const Voigt&) const { return 1; }

  void check() const;

  static std::vector<LawForm<LeeGraphene>> forms();
  static std::vector<LawExample<LeeGraphene>> examples();
};

static_assert(IsotropicLaw<LeeGraphene> && ListedLaw<LeeGraphene>);

}  // namespace membrane
