// The strained lattice itself: LAMMPS's virial beside LAMMPS's energy, and small strain found another way.
#include <fmt/format.h>

#include <cmath>

#include "compare/base/units.hpp"
#include "compare/verify_atoms/groups.hpp"
#include "compare/verify_atoms/outside_numbers.hpp"

namespace validate::verify {
namespace {

using atomistic::HomogeneousState;
using atomistic::StrainState;

constexpr double step = 1e-3;

/// dW/dE by two central differences, extrapolated.
double slope(const std::vector<HomogeneousState>& states, std::size_t first) {
  const auto difference = [&](std::size_t k, double h) {
    return (states[k].energy_eV_per_A2 - states[k + 1].energy_eV_per_A2) / (2 * h);
  };
  return (4 * difference(first, step) - difference(first + 2, 2 * step)) / 3;
}

void add_neighbours(std::vector<StrainState>& strains, StrainState at, double StrainState::*component) {
  for (const double h : {step, -step, 2 * step, -2 * step}) {
    StrainState& near = strains.emplace_back(at);
    near.*component += h;
  }
}

void one_state(Ledger& ledger, Laboratory& laboratory, const std::string& potential, const StrainState& at) {
  std::vector<StrainState> strains = {at};
  for (auto component : {&StrainState::E11, &StrainState::E22, &StrainState::E12})
    add_neighbours(strains, at, component);
  const auto states = laboratory.states(potential, strains);
  ledger.begin(fmt::format("{}, E = {:g}, {:g}, {:g}, {:g}° from zigzag", potential, at.E11, at.E22, at.E12,
                           at.orientation_deg));
  const double size = std::hypot(states[0].S11_eV_per_A2, states[0].S22_eV_per_A2);
  const auto row = [&](const char* quantity, double from_energy, double stress) {
    ledger.equal(quantity, (from_energy - stress) / size, identity(0, "stress is the energy's slope"), 1e-4);
  };
  row("(dW/dE11 - S11) / |S|", slope(states, 1), states[0].S11_eV_per_A2);
  row("(dW/dE22 - S22) / |S|", slope(states, 5), states[0].S22_eV_per_A2);
  row("(dW/dE12 / 2 - S12) / |S|", slope(states, 9) / 2, states[0].S12_eV_per_A2);
}

/// Second differences of the energy alone. W = ½ (C11 + C12) 2 e²/… : (C11 + C12) e² for equal strain, ½ C11 e² for
/// one.
struct FromEnergy {
  double biaxial, C11;
};

FromEnergy from_energy(Laboratory& laboratory, const std::string& potential) {
  constexpr double e = 2e-3;
  const auto s = laboratory.states(
      potential, {{e, e, 0, 0}, {-e, -e, 0, 0}, {e, 0, 0, 0}, {-e, 0, 0, 0}, {0, e, 0, 0}, {0, -e, 0, 0}});
  const auto W = [&](std::size_t k) { return s[k].energy_eV_per_A2; };
  return {(W(0) + W(1)) / (2 * e * e), (W(2) + W(3) + W(4) + W(5)) / (2 * e * e)};
}

}  // namespace

void verify_lattice(Ledger& ledger, Laboratory& laboratory) {
  for (const std::string& potential : laboratory.potentials())
    for (const StrainState& at : {StrainState{0.08, 0.03, 0.02, 11}, StrainState{0.05, 0.05, -0.03, 26}})
      one_state(ledger, laboratory, potential, at);
}

void verify_small_strain(Ledger& ledger, Laboratory& laboratory) {
  for (const std::string& potential : laboratory.potentials()) {
    const PotentialCard& of = laboratory.card(potential);
    const atomistic::Card& card = of.card;
    ledger.begin(potential + ", small strain");
    const FromEnergy energy = from_energy(laboratory, potential);
    const double biaxial = card.C11_eV_per_A2 + card.C12_eV_per_A2;
    ledger.equal("C11 + C12, card / second difference of the energy", biaxial / energy.biaxial,
                 identity(1, "slope of the stress and curvature of the energy"), 0.002);
    ledger.equal("C11, card / second difference of the energy", card.C11_eV_per_A2 / energy.C11,
                 identity(1, "slope of the stress and curvature of the energy"), 0.01,
                 "a knot at 120° shows here, one part in 200 for AIREBO");
    if (of.law) {
      const auto rest = of.law->law({0, 0, 0}).tangent_eV_per_A2;
      ledger.equal("law's C11 at rest / card's", rest(0, 0) / card.C11_eV_per_A2, identity(1, "held in the fit"), 1e-9);
      ledger.equal("law's C12 at rest / card's C11", rest(0, 1) / card.C11_eV_per_A2,
                   identity(card.nu(), "held in the fit"), 1e-9);
    }
    if (const OutsideCard* outside = outside_card(potential)) {
      const double Eh = outside->Eh_N_per_m / N_per_m_per_eV_per_A2;
      ledger.equal("C11 + C12, eV/Å²", biaxial,
                   separate_code(Eh / (1 - outside->nu), "E·h/(1 - nu) of LAMMPS's strained cells"), 0.004);
    }
  }
}

void verify_bending_modulus(Ledger& ledger, Laboratory& laboratory) {
  constexpr PublishedRebo published;
  for (const std::string& potential : laboratory.potentials()) {
    const atomistic::Card& card = laboratory.card(potential).card;
    ledger.begin(potential + ", bending");
    ledger.equal("along zigzag / along armchair", card.bending_modulus_zigzag_eV / card.bending_modulus_armchair_eV,
                 identity(1, "a hexagonal sheet bends alike in every direction"), 1e-3);
    if (const OutsideCard* outside = outside_card(potential))
      ledger.equal("kappa, eV", card.bending_modulus_eV(),
                   separate_code(outside->bending_modulus_eV, "a rippled strip of 120 Å in LAMMPS"), 0.01);
    if (potential == "rebo")
      ledger.equal("kappa, eV", card.bending_modulus_eV(),
                   Reference{published.bending_modulus_eV, std::string(published.bending)}, 0.01);
  }
}

}  // namespace validate::verify
