// The cards' numbers beside those that others have found.
#include <cmath>

#include "compare/base/units.hpp"
#include "compare/verify_atoms/groups.hpp"
#include "compare/verify_atoms/outside_numbers.hpp"

namespace validate::verify {
namespace {

const std::string elsewhere = "LAMMPS 29 Sep 2021, strained cells and rippled strips";

void moduli(Ledger& ledger, const atomistic::Card& card, const OutsideCard& outside) {
  ledger.equal("a0, Å", card.a0_A, separate_code(outside.a0_A, elsewhere), 1e-6);
  ledger.equal("E·h, N/m", card.sheet_modulus_eV_per_A2() * N_per_m_per_eV_per_A2,
               separate_code(outside.Eh_N_per_m, elsewhere), 0.002);
  ledger.equal("nu", card.nu(), separate_code(outside.nu, elsewhere), 0.005);
}

void rebo_as_published(Ledger& ledger, const atomistic::Card& card) {
  constexpr PublishedRebo published;
  ledger.equal("E·h, N/m", card.sheet_modulus_eV_per_A2() * N_per_m_per_eV_per_A2,
               Reference{published.Eh_N_per_m, std::string(published.moduli)}, 0.01, "three digits are published");
  ledger.equal("nu", card.nu(), Reference{published.nu, std::string(published.moduli)}, 0.01,
               "a knot at 120° makes it depend on how it is found");
}

}  // namespace

void verify_constants(Ledger& ledger, Laboratory& laboratory) {
  for (const std::string& potential : laboratory.potentials()) {
    const atomistic::Card& card = laboratory.card(potential).card;
    ledger.begin(potential + ", card");
    if (const OutsideCard* outside = outside_card(potential)) moduli(ledger, card, *outside);
    if (potential == "rebo") rebo_as_published(ledger, card);
    ledger.equal("C66 / ((C11 - C12)/2)", card.C66_eV_per_A2 / ((card.C11_eV_per_A2 - card.C12_eV_per_A2) / 2),
                 identity(1, "a hexagonal sheet is isotropic to first order"), 0.01,
                 "AIREBO's and REBO's knot at 120°");
  }
}

}  // namespace validate::verify
