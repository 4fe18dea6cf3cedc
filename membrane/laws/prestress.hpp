// Prestress as an offset strain: Ē = E + E0 with S_law(E0) = sigma_p, for every law.
#pragma once

#include "membrane/laws/response.hpp"

namespace membrane {

/// Newton's method on S_law(E0) = sigma_p, one response of the law at a time.
class OffsetSearch {
 public:
  OffsetSearch(const Voigt& prestress_eV_per_A2, double sheet_modulus_eV_per_A2);

  bool ended() const { return ended_; }
  const Voigt& strain() const { return strain_; }  ///< the present one; at the end E0, NaN if there is none
  void improve(const Response& at_strain);

 private:
  Voigt prestress_;
  double tolerance_;  ///< eV/Å²
  Voigt strain_ = Voigt::Zero();
  int iterations_ = 0;
  bool ended_ = false;
};

/// E0 as [E11, E22, 2 E12] for a prestress [S11, S22, S12] in eV/Å² (second Piola–Kirchhoff × thickness).
/// With it everything stays isotropic in Ē, also where prestress and strain do not commute. For St
/// Venant–Kirchhoff E0 = [(1 + nu) sigma_p − nu tr(sigma_p) I] / E. NaN where the law cannot carry this
/// prestress.
template <MaterialLaw L>
Voigt offset_strain(const L& law, const Voigt& prestress_eV_per_A2) {
  OffsetSearch search(prestress_eV_per_A2, law.sheet_modulus_eV_per_A2);
  while (!search.ended()) search.improve(law(search.strain()));
  return search.strain();
}

}  // namespace membrane
