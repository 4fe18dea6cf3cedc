#include "reference/mylar_balloon.hpp"

#include <gsl/gsl_sf_ellint.h>

#include <numbers>

namespace reference {

MylarBalloon mylar_balloon() {
  using std::numbers::sqrt2;
  const double K = gsl_sf_ellint_Kcomp(1 / sqrt2, GSL_PREC_DOUBLE);
  const double E = gsl_sf_ellint_Ecomp(1 / sqrt2, GSL_PREC_DOUBLE);
  const double flat_radius = K / sqrt2;  // per inflated radius
  return {sqrt2 * (E - K / 2) / flat_radius, 1 / flat_radius};
}

}  // namespace reference
