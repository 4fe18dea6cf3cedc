#include "membrane/laws/tension_field.hpp"

namespace membrane {

Voigt hidden_strain(const Principal& offset_strain, double natural_width) {
  const Voigt along = offset_strain.axial();
  return (natural_width - offset_strain.smaller) * Voigt(1 - along[0], 1 - along[1], -2 * along[2]);
}

Response wrinkled_response(const UniaxialResponse& along, const Principal& strain) {
  const Voigt m11 = strain.axial();
  const Voigt m12 = strain.shear();
  const double turning = along.force_eV_per_A2 / (2 * (strain.larger - strain.smaller));
  Response at;
  at.energy_eV_per_A2 = along.energy_eV_per_A2;
  at.force_eV_per_A2 = along.force_eV_per_A2 * m11;
  at.tangent_eV_per_A2 = along.tangent_eV_per_A2 * m11 * m11.transpose() + turning * m12 * m12.transpose();
  return at;
}

}  // namespace membrane
