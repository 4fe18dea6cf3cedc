#include "compare/verify_atoms/groups.hpp"

namespace validate::verify {
namespace {

using InLaboratory = void (*)(Ledger&, Laboratory&);

Group group(std::string_view name, std::string_view what, const std::shared_ptr<Laboratory>& laboratory,
            InLaboratory run) {
  return {name, what, [laboratory, run](Ledger& ledger) { run(ledger, *laboratory); }};
}

}  // namespace

std::vector<Group> atoms_groups(const std::shared_ptr<Laboratory>& in) {
  return {
      group("forces", "LAMMPS's forces: -dE/dx, balance, translation, rotation", in, verify_forces),
      group("curve", "AIREBO, R = 30 A, point load, against a program written separately", in, verify_curve),
      group("equilibrium", "stationarity, load, rim, work, ranks of a path", in, verify_equilibrium),
      group("constants", "lattice constant and moduli of the cards, publications", in, verify_constants),
  };
}

std::vector<Group> calibration_groups(const std::shared_ptr<Laboratory>& in) {
  return {
      group("law", "the laws' stresses under strains that they were not fitted to; derivatives", in, verify_law),
      group("lattice", "stress of the strained lattice from its energy", in, verify_lattice),
      group("small", "small strain: law, card, second differences of the energy, numbers from outside", in,
            verify_small_strain),
      group("kappa", "bending modulus: two directions, numbers from outside", in, verify_bending_modulus),
  };
}

}  // namespace validate::verify
