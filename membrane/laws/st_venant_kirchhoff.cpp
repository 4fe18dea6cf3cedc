#include "membrane/laws/st_venant_kirchhoff.hpp"

#include <cmath>

#include "membrane/base/refusal.hpp"

namespace membrane {

Response StVenantKirchhoff::operator()(const Voigt& strain) const {
  const double c = sheet_modulus_eV_per_A2 / (1 - nu * nu);
  Response at;
  at.tangent_eV_per_A2 << c, nu * c, 0,  //
      nu * c, c, 0,                      //
      0, 0, 0.5 * (1 - nu) * c;
  at.force_eV_per_A2 = at.tangent_eV_per_A2 * strain;
  at.energy_eV_per_A2 = 0.5 * at.force_eV_per_A2.dot(strain);
  return at;
}

double StVenantKirchhoff::thickness_stretch(const Voigt& strain) const {
  return std::sqrt(1 - 2 * nu / (1 - nu) * (strain[0] + strain[1]));
}

void StVenantKirchhoff::check() const {
  if (!(sheet_modulus_eV_per_A2 > 0) || !std::isfinite(sheet_modulus_eV_per_A2))
    refuse("law.sheet_modulus_eV_per_A2", sheet_modulus_eV_per_A2, "must be positive and finite");
  if (!(nu > -1 && nu < 1)) refuse("law.nu", nu, "must lie between -1 and 1, both excluded");
}

std::vector<LawForm<StVenantKirchhoff>> StVenantKirchhoff::forms() {
  return {{"svk",
           "St Venant-Kirchhoff: stress in proportion to Green-Lagrange strain, the paper's law",
           {Eh_parameter, nu_parameter},
           [](const LawValues& v) {
             return StVenantKirchhoff{v.at("Eh"), v.at("nu")};
           }}};
}

std::vector<LawExample<StVenantKirchhoff>> StVenantKirchhoff::examples() {
  std::vector<LawExample<StVenantKirchhoff>> all;
  for (double ratio : {0.19, -0.158, 0.0, 0.45})
    all.push_back({with_nu("St Venant-Kirchhoff", ratio), {example_modulus_eV_per_A2, ratio}});
  return all;
}

}  // namespace membrane
