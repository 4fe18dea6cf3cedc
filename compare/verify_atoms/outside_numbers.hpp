// Numbers of potentials' sheets that others have found.
#pragma once

#include <span>
#include <string_view>

namespace validate::verify {

/// T = 0, flat. Computed with LAMMPS 29 Sep 2021 by programs written separately from this project: lattice constant
/// from the zero of the membrane force, moduli by strained cells, bending modulus of a rippled strip of 120 Å.
struct OutsideCard {
  std::string_view potential;
  double a0_A, Eh_N_per_m, nu, bending_modulus_eV;
};

/// Of the potential, or nullptr.
const OutsideCard* outside_card(std::string_view potential);

/// REBO 2002 as published.
struct PublishedRebo {
  double Eh_N_per_m = 243, nu = 0.397, bending_modulus_eV = 1.40;
  std::string_view moduli = "Arroyo & Belytschko 2004; Lu, Arroyo & Huang, J. Phys. D 42 (2009) 102002";
  std::string_view bending = "Lu, Arroyo & Huang, J. Phys. D 42 (2009) 102002, arXiv:0901.4370";
};

}  // namespace validate::verify
