#include "membrane/laws/isotropic.hpp"

namespace membrane {

Response isotropic_response(const InvariantEnergy& energy, const Principal& strain) {
  const double q = 0.5 * (strain.larger - strain.smaller);
  const Voigt one(1, 1, 0);
  const Voigt n(strain.cos_2theta, -strain.cos_2theta, strain.sin_2theta);
  const Voigt m = strain.shear();
  Response response;
  response.energy_eV_per_A2 = energy.W;
  response.force_eV_per_A2 = energy.W_I * one + 0.5 * q * energy.W_q_over_q * n;
  response.tangent_eV_per_A2 = energy.W_II * one * one.transpose() +
                               0.5 * energy.W_Iq * (one * n.transpose() + n * one.transpose()) +
                               0.25 * energy.W_qq * n * n.transpose() + 0.25 * energy.W_q_over_q * m * m.transpose();
  return response;
}

}  // namespace membrane
