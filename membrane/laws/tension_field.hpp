// The relaxed (tension-field) form of any isotropic law: compression is given up for free by wrinkling.
// Gil et al. 2010, Eqs. 7, 9, 12 (corrected), 15, written in the offset strain Ē = E + E0;
// quasi-convexification after Pipkin, IMA J. Appl. Math. 36 (1986) 85, and Steigmann, Proc. R. Soc. A 429
// (1990) 141.
#pragma once

#include "membrane/laws/directional_wrinkling.hpp"
#include "membrane/laws/principal.hpp"
#include "membrane/laws/response.hpp"
#include "membrane/laws/sheet_state.hpp"

namespace membrane {

/// The branch of the relaxed energy at principal strains Ē1 ≥ Ē2. The natural width decides, not the sign of
/// S2, so that a law that softens in compression is judged rightly too.
template <IsotropicLaw L>
SheetState sheet_state(const L& law, const Principal& strain) {
  if (!(strain.larger > 0)) return SheetState::slack;
  return strain.smaller > law.natural_width(strain.larger) ? SheetState::taut : SheetState::wrinkled;
}

template <IsotropicLaw L>
SheetState sheet_state(const L& law, const Voigt& offset_strain) {
  return sheet_state(law, principal_strains(offset_strain));
}

/// What wrinkles hide of the strain Ē across them, as [E11, E22, 2 E12]: with it a wrinkled sheet has its
/// natural width.
Voigt hidden_strain(const Principal& offset_strain, double natural_width);

/// Zero where there are no wrinkles.
template <IsotropicLaw L>
Voigt hidden_strain(const L& law, const Voigt& offset_strain) {
  const Principal at = principal_strains(offset_strain);
  if (sheet_state(law, at) != SheetState::wrinkled) return Voigt::Zero();
  return hidden_strain(at, law.natural_width(at.larger));
}

/// psi(Ē1) of the uniaxial law with S = S1 M1⊗M1 and
/// dS/dE = dS1/dE1 M1⊗M1⊗M1⊗M1 + S1 / (2(Ē1 − Ē2)) (M1⊗M2 + M2⊗M1)⊗(M1⊗M2 + M2⊗M1):
/// the second term turns the wrinkles with the strain. Ē1 > Ē2 here, since equal positive strains are taut.
Response wrinkled_response(const UniaxialResponse& along, const Principal& strain);

/// The relaxed law at the offset strain Ē (prestress included): taut, wrinkled or slack, C¹ over both
/// borders.
template <IsotropicLaw L>
Response tension_field(const L& law, const Voigt& offset_strain) {
  const Principal strain = principal_strains(offset_strain);
  switch (sheet_state(law, strain)) {
    case SheetState::taut:
      return law(offset_strain);
    case SheetState::wrinkled:
      return wrinkled_response(law.uniaxial(strain.larger), strain);
    case SheetState::slack:
      break;
  }
  return {};
}

}  // namespace membrane
