// Prestress as an offset strain: Ē = E + E0 with S_law(E0) = sigma_p, for every law.
#pragma once

#include <Eigen/LU>
#include <limits>

#include "membrane/fault.hpp"
#include "membrane/laws/response.hpp"

namespace membrane {

/// E0 as [E11, E22, 2 E12] for a prestress [S11, S22, S12] in eV/Å² (second Piola–Kirchhoff × thickness).
/// With it everything stays isotropic in Ē, also where prestress and strain do not commute. For St
/// Venant–Kirchhoff E0 = [(1 + nu) sigma_p − nu tr(sigma_p) I] / E. NaN where the law cannot carry this
/// prestress.
template <MaterialLaw L>
Voigt offset_strain(const L& law, const Voigt& prestress_eV_per_A2) {
  constexpr int most_iterations = 50;
  constexpr double last = 1e-8;  // of the prestress: Newton's next step leaves the square of it: rounding
  constexpr double noise = 1e-15;
  Voigt strain = Voigt::Zero();
  if (broken(Fault::no_prestress)) return strain;
  for (int i = 0; i < most_iterations; ++i) {
    const Response at = law(strain);
    const Voigt missing = prestress_eV_per_A2 - at.force_eV_per_A2;
    const bool done =
        missing.norm() <= last * prestress_eV_per_A2.norm() + noise * law.sheet_modulus_eV_per_A2;
    strain += at.tangent_eV_per_A2.inverse() * missing;
    if (done) return strain;
  }
  return Voigt::Constant(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace membrane
