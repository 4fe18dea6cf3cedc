// The response that a lattice itself has under homogeneous strain (Cauchy–Born), as coefficients fitted to
// it.
#pragma once

#include <vector>

#include "membrane/laws/form.hpp"
#include "membrane/laws/isotropic.hpp"

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

  InvariantEnergy energy(double I, double q) const;

  Response operator()(const Voigt& strain) const;
  double natural_width(double axial_strain) const;
  UniaxialResponse uniaxial(double axial_strain) const;

  /// A sheet of one atom's thickness has no 3-D parent.
  double thickness_stretch(const Voigt&) const { return 1; }

  void check() const;

  static std::vector<LawForm<CauchyBorn>> forms();
  static std::vector<LawExample<CauchyBorn>> examples();
};

static_assert(IsotropicLaw<CauchyBorn> && ListedLaw<CauchyBorn>);

}  // namespace membrane
