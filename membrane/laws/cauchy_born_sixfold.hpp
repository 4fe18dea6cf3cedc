// The response of a hexagonal lattice under homogeneous strain with its directions: the same along zigzag
// every 60°.
#pragma once

#include <vector>

#include "membrane/laws/form.hpp"
#include "membrane/laws/response.hpp"

namespace membrane {

/// Functions of the angle θ from zigzag to the larger principal strain that a lattice with mirrors along
/// zigzag and armchair allows. With d = (E11 − E22)/2 + i E12 in zigzag axes (|d| = q, its argument 2θ):
enum class Sixfold {
  none,            ///< 1
  cosine,          ///< cos 6θ; q³ cos 6θ = Re d³ is the invariant of lowest order
  cosine_squared,  ///< cos² 6θ; q⁶ cos² 6θ = (Re d³)²
  knots,           ///< Σ |cos(2θ + 2πk/3)|³, k = 0, 1, 2; times q³ it is Σ |Re(d e^{2πik/3})|³, of a bond-order
                   ///< potential's knots at the undeformed angles
};

/// c I^a q^b f(θ).
struct SixfoldTerm {
  int a = 0;
  int b = 0;
  Sixfold angle = Sixfold::none;
  double coefficient_eV_per_A2 = 0;
};

/// W = ¼ (C11 + C12) I² + (C11 − C12) q² + Σ c I^a q^b f(θ) with a + b ≥ 3, b ≠ 1, and b ≥ 3 where f is not
/// 1: a hexagonal lattice is isotropic to second order. W is linear in the coefficients.
struct CauchyBornSixfold {
  double sheet_modulus_eV_per_A2 = 0;  ///< E·h = C11 − C12²/C11
  double nu = 0;                       ///< C12 / C11, in (−1, 1)
  double zigzag_rad = 0;               ///< from the sheet's x axis to a zigzag direction
  std::vector<SixfoldTerm> terms;

  static constexpr int highest_degree = 8;

  Response operator()(const Voigt& strain) const;

  /// Along zigzag, a mirror of the lattice: no shear across it.
  double natural_width(double axial_strain) const;

  /// A sheet of one atom's thickness has no 3-D parent.
  double thickness_stretch(const Voigt&) const { return 1; }

  void check() const;

  static std::vector<LawForm<CauchyBornSixfold>> forms();
  static std::vector<LawExample<CauchyBornSixfold>> examples();
};

static_assert(DirectionalLaw<CauchyBornSixfold> && ListedLaw<CauchyBornSixfold>);

}  // namespace membrane
