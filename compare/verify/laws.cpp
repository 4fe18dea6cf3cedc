// Material laws: derivatives, objectivity, isotropy, small strain, natural width; and the misprinted
// equations.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "compare/verify/groups.hpp"
#include "compare/verify/law_cases.hpp"
#include "compare/verify/misprints.hpp"
#include "compare/verify/taylor.hpp"
#include "membrane/laws/list.hpp"
#include "membrane/laws/tension_field.hpp"
#include "membrane/sheets/mesh.hpp"
#include "membrane/terms/kinematics.hpp"

namespace validate::verify {
namespace {

using namespace membrane;

/// Strain with principal values e1, e2, the first at an angle (radians) to x.
Voigt principal_at(double e1, double e2, double angle) {
  const double mean = 0.5 * (e1 + e2), half = 0.5 * (e1 - e2);
  return {mean + half * std::cos(2 * angle), mean - half * std::cos(2 * angle), 2 * half * std::sin(2 * angle)};
}

/// Taut and wrinkled, along and across the axes.
std::vector<Voigt> states() {
  return {principal_at(0.05, 0.03, 0.3),  principal_at(0.06, 0.01, 0.9),  principal_at(0.08, 0.075, -0.7),
          principal_at(0.05, -0.2, -0.4), principal_at(0.03, -0.05, 1.1), principal_at(0.07, -0.1, 0)};
}

/// The least order over the states: 2 where the derivative is right, 1 where it is not.
template <class Response>
void derivative_orders(Ledger& ledger, const std::string& form, double Eh, Response response,
                       const std::vector<Voigt>& at) {
  const Voigt v(0.6, -0.3, 0.8);
  constexpr double step = 1e-4;
  const double noise = 1e-13 * Eh;
  double of_energy = std::numeric_limits<double>::infinity(), of_force = of_energy;
  for (const Voigt& E : at) {
    const auto here = response(E);
    const auto energy = [&](double t) {
      return std::abs(response(E + t * v).energy_eV_per_A2 - here.energy_eV_per_A2 - t * here.force_eV_per_A2.dot(v));
    };
    const auto force = [&](double t) -> double {
      return (response(E + t * v).force_eV_per_A2 - here.force_eV_per_A2 - t * here.tangent_eV_per_A2 * v).norm();
    };
    of_energy = std::min(of_energy, observed_order(energy, 16 * step, 1e-15 * Eh));
    of_force = std::min(of_force, observed_order(force, step, noise));
  }
  const Reference two = identity(2, "psi(E + tV) - psi - t S:V = O(t^2)");
  ledger.equal("order of psi's remainder, " + form, of_energy, two, 0.05, "least over the states");
  if (std::isinf(of_force)) return;  // a linear law: the remainder is rounding
  ledger.equal("order of S's remainder, " + form, of_force, identity(2, "S(E + tV) - S - t dS/dE:V = O(t^2)"), 0.05,
               "least over the states");
}

/// The largest change of the relaxed energy when the sheet is turned in space after, or in its plane before,
/// the strain.
template <class L>
double change_by_rotation(const L& law) {
  const Triangle triangle = make_triangle({{0, 0}, {1.3, 0.2}, {0.4, 0.9}}, {0, 1, 2});
  Eigen::Matrix3d X;
  X << 0, 1.3, 0.4, 0, 0.2, 0.9, 0, 0, 0;
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Eigen::Vector3d(0.3, -1, 2).normalized()).matrix();
  const auto energy = [&](const Eigen::Matrix3d& x) {
    return tension_field(law, Deformation(triangle, x - X).green_lagrange()).energy_eV_per_A2;
  };
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-0.1, 0.1);
  double largest = 0;
  for (int i = 0; i < 10; ++i) {
    Eigen::Matrix3d x = X;
    for (double& component : x.reshaped()) component += any(random);
    largest = std::max(largest, std::abs(energy(turn * x) - energy(x)));
  }
  for (const Voigt& E : states()) {
    const Principal p = principal_strains(E);
    const double angle = 0.5 * std::atan2(p.sin_2theta, p.cos_2theta);
    const Voigt there = principal_at(p.larger, p.smaller, angle + 2.3);
    largest = std::max(largest, std::abs(tension_field(turned(law, 2.3), there).energy_eV_per_A2 -
                                         tension_field(law, E).energy_eV_per_A2));
  }
  return largest / law.sheet_modulus_eV_per_A2;
}

template <class L>
void verify_law(Ledger& ledger, const L& law) {
  const double Eh = law.sheet_modulus_eV_per_A2;
  derivative_orders(
      ledger, "relaxed", Eh, [&](const Voigt& E) { return tension_field(law, E); }, states());
  derivative_orders(
      ledger, "unrelaxed", Eh, [&](const Voigt& E) { return law(E); }, states());
  ledger.equal("energy's change by rotation / Eh", change_by_rotation(law),
               identity(0, "psi(QF) = psi(F), psi(Q E Q^T) = psi(E)"), 1e-14);

  const double c = Eh / (1 - law.nu * law.nu);
  Eigen::Matrix3d hooke;
  hooke << c, law.nu * c, 0, law.nu * c, c, 0, 0, 0, 0.5 * (1 - law.nu) * c;
  ledger.equal("|dS/dE - Hooke| / Eh at rest", (law(Voigt::Zero()).tangent_eV_per_A2 - hooke).norm() / Eh,
               closed_form(0, "Eh/(1-nu^2) [[1,nu,0],[nu,1,0],[0,0,(1-nu)/2]]"), 1e-13);

  constexpr double axial = 0.05;
  const Voigt natural(axial, law.natural_width(axial), 0);
  ledger.equal("S2 / Eh at the natural width", law(natural).force_eV_per_A2[1] / Eh, identity(0, "S2 = 0"), 1e-14);
  const Voigt taut(axial, natural[1] + 0.1 * std::abs(natural[1]), 0);
  ledger.equal("S1 relaxed / S1 unrelaxed, little wider",
               tension_field(law, taut).force_eV_per_A2[0] / law(taut).force_eV_per_A2[0],
               identity(1, "taut where wider than the natural width"), 1e-15);
  ledger.equal("S1 wrinkled / S1 at natural width",
               tension_field(law, Voigt(axial, -0.3, 0)).force_eV_per_A2[0] / law(natural).force_eV_per_A2[0],
               identity(1, "relaxed energy = least over the width (Pipkin 1986)"), 1e-13);
}

}  // namespace

void verify_laws(Ledger& ledger) {
  for (const auto& [name, law] : example_laws()) {
    ledger.begin(name);
    std::visit([&]<MaterialLaw L>(const L& any) { verify_law(ledger, any); }, law);
  }
  verify_law_cases(ledger);
  verify_misprints(ledger);
}

}  // namespace validate::verify
