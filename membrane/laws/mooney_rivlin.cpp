#include "membrane/laws/mooney_rivlin.hpp"

#include <cmath>
#include <limits>

#include "membrane/base/refusal.hpp"

namespace membrane {

double MooneyRivlin::log_thickness(double I, double log_area) const {
  constexpr int most_iterations = 100;
  const double free = 1 - 2 * nu;
  const double tied = 2 * nu - 2 * second_share * free;
  const double pull = 1 + second_share + 2 * second_share * I;  // (µ1 + µ2 A) / µ
  double y = 0;
  for (int i = 0; i < most_iterations; ++i) {
    const double square = std::exp(2 * y);
    const double slope = 2 * free * pull * square + tied;
    if (!(slope > 0)) break;
    const double excess = free * (pull * std::expm1(2 * y) + 2 * second_share * I) + tied * (y + log_area);
    y -= excess / slope;
    if (std::abs(excess) <= 1e-9 * slope) return y;  // Newton: what is left is the square of that
  }
  return std::numeric_limits<double>::quiet_NaN();
}

InvariantEnergy MooneyRivlin::energy(double I, double q) const {
  const double mu = sheet_modulus_eV_per_A2 / (2 * (1 + nu));
  const double mu2 = second_share * mu;
  const double mu1 = mu - mu2;
  // L(I, q) = ½ ln det C, det C = (1 + I)² − 4 q²; written so that nothing cancels at small strain.
  const double grown = I * (2 + I) - 4 * q * q;
  const double det = 1 + grown;
  const double L = 0.5 * std::log1p(grown);
  const double L_I = (1 + I) / det;
  const double L_q_over_q = -4 / det;
  const double L_q = q * L_q_over_q;
  const double L_II = 1 / det - 2 * L_I * L_I;

  const double y = log_thickness(I, L);
  const double swell = std::expm1(2 * y);  // lambda3² − 1
  const double square = 1 + swell;
  const double pull = mu1 + mu2 * (2 + 2 * I);
  const double free = 1 - 2 * nu;
  const double tied = 2 * nu - 2 * second_share * free;
  const double slope = 2 * free * pull / mu * square + tied;
  const double y_A = -free * second_share * square / slope;
  const double y_L = -tied / slope;

  const double W_A = 0.5 * (mu1 + mu2 * square);
  const double W_L = mu2 * det - pull * square;
  const double W_AA = mu2 * square * y_A;
  const double W_AL = mu2 * square * y_L;
  const double W_LL = 2 * mu2 * det - 2 * pull * square * y_L;

  const double log_J = y + L;
  const double second = I + swell + I * swell;         // (A lambda3² − 2)/2
  const double lift = mu1 * swell + 2 * mu2 * second;  // −Λ ln J
  InvariantEnergy at;
  at.W = 0.5 * mu1 * (2 * I + swell) + 0.5 * mu2 * (grown + 2 * second) - (mu1 + 2 * mu2 + 0.5 * lift) * log_J;
  at.W_I = 2 * W_A + W_L * L_I;
  at.W_q_over_q = W_L * L_q_over_q;
  at.W_II = 4 * W_AA + 4 * W_AL * L_I + W_LL * L_I * L_I + W_L * L_II;
  at.W_Iq = (2 * W_AL + W_LL * L_I) * L_q - 2 * W_L * L_I * L_q;
  at.W_qq = W_LL * L_q * L_q + W_L * (L_q_over_q - 2 * L_q * L_q);
  return at;
}

Response MooneyRivlin::operator()(const Voigt& strain) const { return isotropic_response(*this, strain); }

double MooneyRivlin::natural_width(double axial_strain) const { return solve_natural_width(*this, axial_strain); }

UniaxialResponse MooneyRivlin::uniaxial(double axial_strain) const { return uniaxial_response(*this, axial_strain); }

double MooneyRivlin::thickness_stretch(const Voigt& strain) const {
  const double I = strain[0] + strain[1];
  const double det = (1 + 2 * strain[0]) * (1 + 2 * strain[1]) - strain[2] * strain[2];
  return std::exp(log_thickness(I, 0.5 * std::log(det)));
}

void MooneyRivlin::check() const {
  if (!(sheet_modulus_eV_per_A2 > 0) || !std::isfinite(sheet_modulus_eV_per_A2))
    refuse("law.sheet_modulus_eV_per_A2", sheet_modulus_eV_per_A2, "must be positive and finite");
  if (!(nu > -1 && nu <= 0.5))
    refuse("law.nu", nu, "must lie above -1 and not above 0.5 (incompressible): the law has a 3-D parent");
  if (!(second_share >= 0 && second_share <= 1))
    refuse("law.second_share", second_share, "must lie between 0 (neo-Hookean) and 1");
}

std::vector<LawForm<MooneyRivlin>> MooneyRivlin::forms() {
  return {{"neo-hookean",
           "neo-Hookean rubber in plane stress, incompressible at nu = 0.5",
           {Eh_parameter, nu_parameter},
           [](const LawValues& v) { return neo_hookean(v.at("Eh"), v.at("nu")); }},
          {"mooney-rivlin",
           "Mooney-Rivlin rubber in plane stress, incompressible at nu = 0.5",
           {Eh_parameter, nu_parameter, {"second_share", "", "mu2 / (mu1 + mu2), from 0 (neo-Hookean) to 1"}},
           [](const LawValues& v) {
             return MooneyRivlin{v.at("Eh"), v.at("nu"), v.at("second_share")};
           }}};
}

std::vector<LawExample<MooneyRivlin>> MooneyRivlin::examples() {
  constexpr double modulus = example_modulus_eV_per_A2;
  std::vector<LawExample<MooneyRivlin>> all;
  for (double ratio : {0.3, 0.0, -0.158}) all.push_back({with_nu("neo-Hookean", ratio), neo_hookean(modulus, ratio)});
  all.push_back({"neo-Hookean, incompressible", neo_hookean(modulus, 0.5)});
  for (double ratio : {0.3, 0.0, -0.158}) all.push_back({with_nu("Mooney-Rivlin", ratio), {modulus, ratio, 0.2}});
  all.push_back({"Mooney-Rivlin, incompressible", {modulus, 0.5, 0.2}});
  return all;
}

}  // namespace membrane
