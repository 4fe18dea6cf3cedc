// The relaxed (tension-field) form of a law that has directions of its own: the wrinkles choose theirs.
#pragma once

#include "membrane/laws/response.hpp"
#include "membrane/laws/sheet_state.hpp"

namespace membrane {

/// The relaxed energy is the least of psi(Ē + P) over the strains P ⪰ 0 that wrinkles can hide. For a convex
/// law that means P = 0 where S(Ē) has no compressive part (taut), P = −Ē where Ē has no extension (slack),
/// and else P = a n⊗n with a > 0 and S n = 0 (wrinkled), n at an angle β to the x axis.
struct Wrinkles {
  SheetState state = SheetState::taut;
  double hidden = 0;  ///< a; NaN where no n was found
  double angle_rad = 0;

  /// n⊗n and its first two derivatives by β, as strains [E11, E22, 2 E12].
  Voigt across() const;
  Voigt turning() const;
  Voigt bending() const;

  Voigt strain() const;  ///< a n⊗n; zero where there are no wrinkles
};

/// The state at an offset strain Ē. The width at which the force across the larger strain vanishes decides
/// where to look, not the sign of the force, so that a law that softens in compression is judged rightly too.
/// This and the relaxed law are there for the laws that directional_wrinkling.cpp names at its end.
template <DirectionalLaw L>
Wrinkles wrinkles_of(const L& law, const Voigt& strain);

template <DirectionalLaw L>
SheetState sheet_state(const L& law, const Voigt& offset_strain) {
  return wrinkles_of(law, offset_strain).state;
}

/// What wrinkles hide of the strain Ē across them, as [E11, E22, 2 E12]. Zero where there are none.
template <DirectionalLaw L>
Voigt hidden_strain(const L& law, const Voigt& offset_strain) {
  return wrinkles_of(law, offset_strain).strain();
}

/// The relaxed law. Wrinkled: psi and S of Ē + a n⊗n, S = S1 t⊗t; and since a and n follow the strain,
/// dS/dE = D − D G (Gᵀ D G + K)⁻¹ Gᵀ D, G = [d(n⊗n)/dβ, n⊗n], where K holds 2 S1/a against turning.
template <DirectionalLaw L>
Response tension_field(const L& law, const Voigt& offset_strain);

}  // namespace membrane
