// The calibrated laws under strains that nothing was fitted to, and their derivatives.
#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "compare/potential/law/states.hpp"
#include "compare/verify/taylor.hpp"
#include "compare/verify_atoms/groups.hpp"
#include "membrane/laws/principal.hpp"

namespace validate::verify {
namespace {

using atomistic::HomogeneousState;
using atomistic::StrainState;
using membrane::Voigt;

/// As the fit judges it: relative to the state's membrane force.
double misfit(const HomogeneousState& state, const Voigt& law) {
  const double size = size_of(state);
  return std::hypot(law[0] - state.S11_eV_per_A2, law[1] - state.S22_eV_per_A2, law[2] - state.S12_eV_per_A2) / size;
}

/// Where the sheet is stable: beyond, its answer need not be smooth.
bool convex(const CalibratedLaw& law, double E1, double E2) {
  const Eigen::Matrix3d tangent = law.law({E1, E2, 0}).tangent_eV_per_A2;
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(tangent).eigenvalues()[0] > 0;
}

/// Principal strains within the law's range where it is convex, drawn at random; the same on every machine.
std::vector<StrainState> drawn_strains(const CalibratedLaw& law, double degrees, unsigned seed) {
  constexpr std::size_t count = 16;
  std::mt19937 generator(seed);
  const auto draw = [&] { return -0.02 + 0.2 * (generator() / 4294967295.0); };
  std::vector<StrainState> strains;
  while (strains.size() < count) {
    const double one = draw(), two = draw();
    if (law.within(std::max(one, two), std::min(one, two)) && convex(law, std::max(one, two), std::min(one, two)))
      strains.push_back({std::max(one, two), std::min(one, two), 0, degrees});
  }
  return strains;
}

template <class Law>
double largest_misfit(const std::vector<HomogeneousState>& states, const Law& law) {
  double largest = 0;
  for (const HomogeneousState& s : states)
    largest = std::max(largest, misfit(s, law({s.strain.E11, s.strain.E22, 0}).force_eV_per_A2));
  return largest;
}

const std::string unfitted = "the lattice under 16 strains that were not fitted";

/// A form that holds between its states misses there by no more than a few times what it misses at them, or than a
/// share of what it is there for.
constexpr double times_fitted = 3, smallest_misfit = 1e-3, share_of_directions = 0.1, smallest_bond_misfit_A = 1e-3;

/// Largest misfit of the form with directions at the states that it was fitted to.
double fitted_misfit(const CalibratedLaw& law) {
  double largest = 0;
  for (const CalibratedState& s : law.states) {
    if (s.atoms.longest_bond_A > law.range.fitted_A) continue;
    membrane::CauchyBornSixfold turned = law.sixfold;
    turned.zigzag_rad = -s.atoms.strain.orientation_deg * std::numbers::pi / 180;
    largest = std::max(largest, misfit(s.atoms, turned({s.atoms.strain.E11, s.atoms.strain.E22, 0}).force_eV_per_A2));
  }
  return largest;
}

void isotropic_law(Ledger& ledger, Laboratory& laboratory, const std::string& potential, const CalibratedLaw& law) {
  ledger.begin(potential + ", isotropic law, 15° from zigzag");
  auto states = laboratory.states(potential, drawn_strains(law, averaged_deg, 1));
  for (HomogeneousState& s : states) s.S12_eV_per_A2 = 0;  // left out by the form
  ledger.equal("largest misfit of the stress", largest_misfit(states, law.law), identity(0, unfitted),
               std::max(times_fitted * law.worst_misfit, smallest_misfit),
               fmt::format("fitted states: {:.2g}", law.worst_misfit));
}

/// Of the three directions the one with the longest bond is what the law foretells.
void longest_bond(Ledger& ledger, Laboratory& laboratory, const std::string& potential, const CalibratedLaw& law) {
  ledger.begin(potential + ", longest bond of any direction");
  std::vector<std::vector<HomogeneousState>> along;
  for (const double degrees : {zigzag_deg, averaged_deg, armchair_deg})
    along.push_back(laboratory.states(potential, drawn_strains(law, degrees, 1)));
  double worst = 0;
  for (std::size_t i = 0; i < along[0].size(); ++i) {
    double longest = 0;
    for (const auto& states : along) longest = std::max(longest, states[i].longest_bond_A);
    const StrainState& at = along[0][i].strain;
    worst = std::max(worst, std::abs(law.longest_bond(at.E11, at.E22) - longest));
  }
  ledger.equal("largest error, Å", worst, identity(0, unfitted),
               std::max(times_fitted * law.longest_bond.worst_misfit_A, smallest_bond_misfit_A),
               fmt::format("fitted states: {:.2g} Å", law.longest_bond.worst_misfit_A));
}

void sixfold_law(Ledger& ledger, Laboratory& laboratory, const std::string& potential, const CalibratedLaw& law) {
  for (const double degrees : {7.0, 22.0}) {
    ledger.begin(fmt::format("{}, law with directions, {:g}° from zigzag", potential, degrees));
    membrane::CauchyBornSixfold turned = law.sixfold;
    turned.zigzag_rad = -degrees * std::numbers::pi / 180;
    const auto states = laboratory.states(potential, drawn_strains(law, degrees, 2));
    const double fitted = fitted_misfit(law), without = largest_misfit(states, law.law);
    ledger.equal("largest misfit of the stress", largest_misfit(states, turned), identity(0, unfitted),
                 std::max(times_fitted * fitted, share_of_directions * without),
                 fmt::format("fitted states: {:.2g}; the law without directions: {:.2g}", fitted, without));
  }
}

template <class Law>
void derivatives(Ledger& ledger, const std::string& name, const Law& law) {
  ledger.begin(name);
  const Voigt at(0.06, 0.02, 0.03), along(0.7, -0.4, 0.9);
  const auto here = law(at);
  const double scale = law.sheet_modulus_eV_per_A2;
  const auto of_energy = [&](double t) {
    return std::abs(law(at + t * along).energy_eV_per_A2 - here.energy_eV_per_A2 - t * here.force_eV_per_A2.dot(along));
  };
  const auto of_force = [&](double t) {
    return (law(at + t * along).force_eV_per_A2 - here.force_eV_per_A2 - t * here.tangent_eV_per_A2 * along).norm();
  };
  ledger.equal("order of the energy's remainder", observed_order(of_energy, 2e-3, 1e-15 * scale),
               identity(2, "psi(E + tV) - psi - t S:V = O(t^2)"), 0.05);
  ledger.equal("order of the force's remainder", observed_order(of_force, 2e-3, 1e-15 * scale),
               identity(2, "S(E + tV) - S - t dS/dE:V = O(t^2)"), 0.05);
}

}  // namespace

void verify_law(Ledger& ledger, Laboratory& laboratory) {
  for (const std::string& potential : laboratory.potentials()) {
    const PotentialCard& card = laboratory.card(potential);
    ledger.begin(potential);
    ledger.equal("has a law (1: yes)", card.law ? 1 : 0, identity(1, "calibrated from its states"), 0, card.no_law);
    if (!card.law) continue;
    isotropic_law(ledger, laboratory, potential, *card.law);
    longest_bond(ledger, laboratory, potential, *card.law);
    sixfold_law(ledger, laboratory, potential, *card.law);
    derivatives(ledger, potential + ", isotropic law", card.law->law);
    derivatives(ledger, potential + ", law with directions", card.law->sixfold);
  }
}

}  // namespace validate::verify
