// Principal values of a symmetric tensor in the plane of the sheet.
#pragma once

#include <cmath>

#include "membrane/laws/response.hpp"

namespace membrane {

/// Principal values and the direction of the larger one. The direction is kept as its double angle, which
/// needs no case for equal values (any direction serves there) and no inverse trigonometry.
struct Principal {
  double larger, smaller;
  double cos_2theta, sin_2theta;

  /// Of the tensor [[xx, xy], [xy, yy]].
  Principal(double xx, double yy, double xy) {
    const double mean = 0.5 * (xx + yy);
    const double half_difference = 0.5 * (xx - yy);
    const double radius = std::sqrt(half_difference * half_difference + xy * xy);
    larger = mean + radius;
    smaller = mean - radius;
    cos_2theta = radius > 0 ? half_difference / radius : 1;
    sin_2theta = radius > 0 ? xy / radius : 0;
  }

  /// M1⊗M1 as [xx, yy, xy].
  Voigt axial() const { return {0.5 * (1 + cos_2theta), 0.5 * (1 - cos_2theta), 0.5 * sin_2theta}; }
  /// M1⊗M2 + M2⊗M1 as [xx, yy, xy].
  Voigt shear() const { return {-sin_2theta, sin_2theta, cos_2theta}; }
};

inline Principal principal_strains(const Voigt& strain) { return {strain[0], strain[1], 0.5 * strain[2]}; }
inline Principal principal_forces(const Voigt& force) { return {force[0], force[1], force[2]}; }

/// The membrane force without its compressive principal part.
inline Voigt tensile_part(const Voigt& force) {
  const Principal at = principal_forces(force);
  if (at.smaller >= 0) return force;
  return at.larger > 0 ? Voigt(at.larger * at.axial()) : Voigt::Zero();
}

}  // namespace membrane
