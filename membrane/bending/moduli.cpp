#include "membrane/bending/moduli.hpp"

#include <cmath>

#include "membrane/base/refusal.hpp"

namespace membrane {

void BendingModuli::check() const {
  if (!(mean_eV > 0) || !std::isfinite(mean_eV)) refuse("bending.mean_eV", mean_eV, "must be positive and finite");
  if (!(gaussian_eV < 0 && gaussian_eV > -2 * mean_eV))
    refuse("bending.gaussian_eV", gaussian_eV, "must lie between -2 bending.mean_eV and 0, both excluded");
}

}  // namespace membrane
