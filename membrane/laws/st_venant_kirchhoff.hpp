// Plane-stress St Venant–Kirchhoff, the law of Gil et al. 2010 (their Eq. 2, with its misprint corrected).
#pragma once

#include <vector>

#include "membrane/laws/form.hpp"
#include "membrane/laws/response.hpp"

namespace membrane {

/// psi = E·h / (2 (1 − nu²)) (E1² + E2² + 2 nu E1 E2),  S = C̄:E.
struct StVenantKirchhoff {
  double sheet_modulus_eV_per_A2 = 0;  ///< E·h, uniaxial modulus times thickness
  double nu = 0;                       ///< Poisson ratio, in (−1, 1)

  Response operator()(const Voigt& strain) const;

  /// S2 = 0 at E2 = −nu E1.
  double natural_width(double axial_strain) const { return -nu * axial_strain; }

  /// psi = E·h E1² / 2: with the width free the law is Hooke's in (E1, S1).
  UniaxialResponse uniaxial(double axial_strain) const {
    const double force = sheet_modulus_eV_per_A2 * axial_strain;
    return {0.5 * force * axial_strain, force, sheet_modulus_eV_per_A2};
  }

  /// S33 = 0 of the 3-D law: lambda3² = 1 − nu/(1 − nu) (lambda1² + lambda2² − 2), NaN where that is
  /// negative.
  double thickness_stretch(const Voigt& strain) const;

  void check() const;

  static std::vector<LawForm<StVenantKirchhoff>> forms();
  static std::vector<LawExample<StVenantKirchhoff>> examples();
};

static_assert(IsotropicLaw<StVenantKirchhoff> && ListedLaw<StVenantKirchhoff>);

}  // namespace membrane
