// A potential of round numbers, without LAMMPS: its card and its law.
#pragma once

#include <numbers>

#include "compare/pairing/pairing.hpp"

namespace sample {

inline constexpr double bond_A = 1.42;
inline constexpr double C11 = 20, C12 = 5, Eh = 18.75, nu = 0.25;  // 20 (1 − 0.25²)
inline constexpr double c3 = -4;                                   // of I³ in the law's energy
inline constexpr double kappa = 1.5;                               // mean of 1.25 and 1.75

inline validate::PotentialCard card(bool with_law = true) {
  validate::PotentialCard card;
  card.card.a0_A = bond_A * std::numbers::sqrt3;
  card.card.C11_eV_per_A2 = C11;
  card.card.C12_eV_per_A2 = C12;
  card.card.C66_eV_per_A2 = 7.5;
  card.card.bending_modulus_zigzag_eV = 1.25;
  card.card.bending_modulus_armchair_eV = 1.75;
  card.card.clamp_margin_bonds = 0.44;
  card.card.slope_margin_bonds = 0.37;
  if (!with_law) return card;
  validate::CalibratedLaw& law = card.law.emplace();
  law.law = {.sheet_modulus_eV_per_A2 = Eh, .nu = nu, .terms = {{.a = 3, .b = 0, .coefficient_eV_per_A2 = c3}}};
  law.longest_bond.rest_A = bond_A;
  law.longest_bond.terms = {{.a = 1, .b = 0, .coefficient_A = 0.71}};
  return card;
}

inline validate::PotentialFile potential_file() {
  validate::PotentialFile file;
  file.potential.name = "round";
  file.potential.interaction_range_A = 2;
  file.potential.artefact_bond_A = 1.7;
  return file;
}

/// What a case of this potential pairs.
class Pairing {
 public:
  explicit Pairing(const validate::Case& c, bool with_law = true)
      : file_(potential_file()),
        card_(card(with_law)),
        sheet_(c, file_.potential, card_.card),
        loads_(validate::pair(c, {file_, card_, sheet_})) {}

  std::vector<validate::PairedLoad>& loads() { return loads_; }
  const validate::PairedSheet& sheet() const { return sheet_; }

 private:
  validate::PotentialFile file_;
  validate::PotentialCard card_;
  validate::PairedSheet sheet_;
  std::vector<validate::PairedLoad> loads_;
};

}  // namespace sample
