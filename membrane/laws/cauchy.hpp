// Cauchy stress of a sheet in plane stress, which needs the thickness that the sheet has now.
#pragma once

#include "membrane/laws/tension_field.hpp"

namespace membrane {

/// The strain that the material itself bears: a wrinkled sheet has its natural width. The actual one can be
/// far narrower, in a tuck, and says nothing of the stress. `strain` is the sheet's, `offset` its prestress
/// as a strain (laws/prestress.hpp).
template <MaterialLaw L>
Voigt natural_strain(const L& law, const Voigt& strain, const Voigt& offset) {
  return strain + hidden_strain(law, Voigt(strain + offset));
}

/// Reference thickness × Cauchy stress, U S U / (lambda1 lambda2 lambda3), as [11, 22, 12] in eV/Å², in the
/// frame turned back with the material (U² = 2 E + 1). Its principal values over h are the principal stresses
/// of a sheet of thickness h. Zero for S = 0 at any thickness.
Voigt cauchy_force(const Voigt& S, const Voigt& strain, double thickness_stretch);

/// The same of a law, at the natural strain where the relaxed sheet is wrinkled.
template <MaterialLaw L>
Voigt cauchy_force(const L& law, const Voigt& strain, const Voigt& offset, bool relaxed) {
  const Voigt natural = relaxed ? natural_strain(law, strain, offset) : strain;
  const Voigt total = strain + offset;
  const Response at = relaxed ? tension_field(law, total) : law(total);
  const double thickness = law.thickness_stretch(natural);
  return cauchy_force(at.force_eV_per_A2, natural, thickness);
}

}  // namespace membrane
