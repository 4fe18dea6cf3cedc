// Cauchy stress of a sheet in plane stress, which needs the thickness that the sheet has now.
#pragma once

#include <Eigen/Eigenvalues>
#include <cmath>

#include "membrane/fault.hpp"
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
/// frame turned back with the material (U² = 2 E + 1, at the natural strain where the relaxed sheet is
/// wrinkled). Its principal values over h are the principal stresses of a sheet of thickness h.
template <MaterialLaw L>
Voigt cauchy_force(const L& law, const Voigt& strain, const Voigt& offset, bool relaxed) {
  const Voigt natural = relaxed ? natural_strain(law, strain, offset) : strain;
  const Voigt S =
      (relaxed ? tension_field(law, Voigt(strain + offset)) : law(Voigt(strain + offset))).force_eV_per_A2;
  if (S.isZero(0)) return Voigt::Zero();
  const Eigen::Matrix2d C{{1 + 2 * natural[0], natural[2]}, {natural[2], 1 + 2 * natural[1]}};
  const Eigen::Matrix2d U = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(C).operatorSqrt();
  const Eigen::Matrix2d force{{S[0], S[2]}, {S[2], S[1]}};
  const double thickness = broken(Fault::constant_thickness) ? 1 : law.thickness_stretch(natural);
  const Eigen::Matrix2d pushed = U * force * U / (std::sqrt(C.determinant()) * thickness);
  return {pushed(0, 0), pushed(1, 1), pushed(0, 1)};
}

}  // namespace membrane
