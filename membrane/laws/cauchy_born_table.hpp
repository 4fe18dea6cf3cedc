// The response of a lattice under homogeneous strain as a table: splines in place of a polynomial's
// coefficients.
#pragma once

#include <vector>

#include "membrane/laws/form.hpp"
#include "membrane/laws/isotropic.hpp"
#include "membrane/laws/spline.hpp"

namespace membrane {

/// W = ¼ (C11 + C12) I² + (C11 − C12) q² + I³ G(I) + I q² A(I) + q³ B(I, q): the three coefficients of third
/// order of `CauchyBorn` as functions, G and A cubic splines and B a bicubic one over a grid in I and q. Any
/// smooth energy that has these small-strain constants and no term linear in q can be written so, and no
/// choice of the coefficients spoils either; W is linear in them. Beyond the grid the three run into
/// constants (spline.hpp), the law into a cubic.
struct CauchyBornTable {
  double sheet_modulus_eV_per_A2 = 0;  ///< E·h = C11 − C12²/C11
  double nu = 0;                       ///< C12 / C11, in (−1, 1)
  SplineAxis I;                        ///< the range of tr E
  SplineAxis q;                        ///< the range of |E1 − E2|/2, from 0
  /// I.size() of G, I.size() of A, and I.size() × q.size() of B, those of one I after the other.
  std::vector<double> coefficients_eV_per_A2;

  int coefficient_count() const { return I.size() * (2 + q.size()); }

  InvariantEnergy energy(double trace, double shear) const;

  Response operator()(const Voigt& strain) const;
  double natural_width(double axial_strain) const;
  UniaxialResponse uniaxial(double axial_strain) const;

  /// A sheet of one atom's thickness has no 3-D parent.
  double thickness_stretch(const Voigt&) const { return 1; }

  void check() const;

  static std::vector<LawForm<CauchyBornTable>> forms();
  static std::vector<LawExample<CauchyBornTable>> examples();
};

static_assert(IsotropicLaw<CauchyBornTable> && ListedLaw<CauchyBornTable>);

}  // namespace membrane
