#include "membrane/laws/lee_graphene.hpp"

#include <cmath>

#include "membrane/base/refusal.hpp"

namespace membrane {

InvariantEnergy LeeGraphene::energy(double I, double q) const {
  const double A = third_order_modulus_eV_per_A2 * (1 - 3 * nu) / (12 * (1 - nu) * (1 - nu) * (1 - nu));
  const double B = third_order_modulus_eV_per_A2 / (1 - nu * nu);
  InvariantEnergy at = quadratic_energy(sheet_modulus_eV_per_A2, nu, I, q);
  at.W += A * I * I * I + B * I * q * q;
  at.W_I += 3 * A * I * I + B * q * q;
  at.W_q_over_q += 2 * B * I;
  at.W_II += 6 * A * I;
  at.W_Iq += 2 * B * q;
  at.W_qq += 2 * B * I;
  return at;
}

Response LeeGraphene::operator()(const Voigt& strain) const { return isotropic_response(*this, strain); }

UniaxialResponse LeeGraphene::uniaxial(double axial_strain) const {
  const double Eh = sheet_modulus_eV_per_A2;
  const double D = third_order_modulus_eV_per_A2;
  const double e = axial_strain;
  return {(Eh / 2 + D / 3 * e) * e * e, (Eh + D * e) * e, Eh + 2 * D * e};
}

void LeeGraphene::check() const {
  if (!(sheet_modulus_eV_per_A2 > 0) || !std::isfinite(sheet_modulus_eV_per_A2))
    refuse("law.sheet_modulus_eV_per_A2", sheet_modulus_eV_per_A2, "must be positive and finite");
  if (!(nu > -1 && nu < 1)) refuse("law.nu", nu, "must lie between -1 and 1, both excluded");
  if (!std::isfinite(third_order_modulus_eV_per_A2))
    refuse("law.third_order_modulus_eV_per_A2", third_order_modulus_eV_per_A2, "must be finite");
}

std::vector<LawForm<LeeGraphene>> LeeGraphene::forms() {
  return {{"lee",
           "graphene that softens: S = Eh E + D E^2 under uniaxial stress (Lee et al. 2008)",
           {Eh_parameter,
            nu_parameter,
            {"third_order", "eV/Å²", "D, elastic modulus of third order; -690 N/m in the publication",
             LeeGraphene{}.third_order_modulus_eV_per_A2}},
           [](const LawValues& v) {
             return LeeGraphene{v.at("Eh"), v.at("nu"), v.at("third_order")};
           }}};
}

std::vector<LawExample<LeeGraphene>> LeeGraphene::examples() {
  constexpr double modulus = example_modulus_eV_per_A2;
  std::vector<LawExample<LeeGraphene>> all;
  for (double ratio : {0.165, 0.0, 0.45, -0.158})
    all.push_back({with_nu("Lee's graphene", ratio), {modulus, ratio, -2 * modulus}});
  return all;
}

}  // namespace membrane
