#include <Eigen/QR>
#include <algorithm>
#include <stdexcept>

#include "atomistic/response.hpp"
#include "compare/published/numbers.hpp"

namespace validate::published {
namespace {

constexpr double graphite_spacing_A = 3.35;

const atomistic::StressCurve& curve_along(const PotentialCard& card, std::string_view direction) {
  const auto found = std::ranges::find(card.response.curves, direction, &atomistic::StressCurve::direction);
  if (found == card.response.curves.end()) throw std::logic_error("no stress curve along " + std::string(direction));
  return *found;
}

/// E and D of S = E ε + D ε² + G ε³, least squares on S/ε of the curve's points from 1 to 5 % elongation.
struct Cubic {
  double E, D;
};

Cubic cubic_of(const atomistic::StressCurve& curve) {
  constexpr double largest = 0.0501;
  std::vector<std::size_t> used;
  for (std::size_t k = 1; k < curve.strain.size() && curve.strain[k] < largest; ++k) used.push_back(k);
  Eigen::MatrixXd powers(used.size(), 3);
  Eigen::VectorXd secant(used.size());
  for (Eigen::Index i = 0; i < secant.size(); ++i) {
    const std::size_t k = used[static_cast<std::size_t>(i)];
    const double elongation = curve.strain[k], strain = elongation + elongation * elongation / 2;
    powers.row(i) << 1, strain, strain * strain;
    secant[i] = curve.stress_eV_per_A2[k] / (1 + elongation) / strain;  // S = P/λ
  }
  const Eigen::VectorXd found = powers.colPivHouseholderQr().solve(secant);
  return {found[0], found[1]};
}

double third_order(const PotentialCard& card, std::string_view direction) {
  return cubic_of(curve_along(card, direction)).D;
}

/// P = λ S: E e + (D + 3/2 E) e² in the elongation e.
double nominal_third_order(const PotentialCard& card, std::string_view direction) {
  const Cubic cubic = cubic_of(curve_along(card, direction));
  return cubic.D + 1.5 * cubic.E;
}

double strength(const PotentialCard& card, std::string_view direction) {
  return curve_along(card, direction).strength_eV_per_A2;
}

}  // namespace

double number_of(const PotentialCard& p, Subject subject) {
  const atomistic::Card& card = p.card;
  switch (subject) {
    case Subject::lattice_constant:
      return card.a0_A;
    case Subject::sheet_modulus:
      return card.sheet_modulus_eV_per_A2();
    case Subject::poisson:
      return card.nu();
    case Subject::C11:
      return card.C11_eV_per_A2;
    case Subject::C12:
      return card.C12_eV_per_A2;
    case Subject::biaxial_stiffness:
      return card.C11_eV_per_A2 + card.C12_eV_per_A2;
    case Subject::young:
      return card.sheet_modulus_eV_per_A2() / graphite_spacing_A;
    case Subject::third_zigzag:
      return third_order(p, "zigzag");
    case Subject::third_armchair:
      return third_order(p, "armchair");
    case Subject::nominal_third_zigzag:
      return nominal_third_order(p, "zigzag");
    case Subject::nominal_third_armchair:
      return nominal_third_order(p, "armchair");
    case Subject::strength_zigzag:
      return strength(p, "zigzag");
    case Subject::strength_armchair:
      return strength(p, "armchair");
    case Subject::strength_equibiaxial:
      return strength(p, "equibiaxial");
    case Subject::bending:
      return card.bending_modulus_eV();
    case Subject::point_alpha:
    case Subject::point_beta:
    case Subject::taut_disc:
    case Subject::hencky:
    case Subject::figure:
      break;
  }
  throw std::logic_error("not a potential's number");
}

}  // namespace validate::published
