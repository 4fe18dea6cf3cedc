// What each quantity is, of whom, and in which unit ours comes.
#include "compare/published/entry.hpp"

namespace validate::published {

Owner owner_of(Subject subject) {
  switch (subject) {
    case Subject::point_alpha:
    case Subject::point_beta:
    case Subject::taut_disc:
    case Subject::hencky:
      return Owner::membrane;
    case Subject::figure:
      return Owner::figure;
    default:
      return Owner::potential;
  }
}

std::string meaning_of(Subject subject) {
  switch (subject) {
    case Subject::lattice_constant:
      return "lattice constant";
    case Subject::sheet_modulus:
      return "sheet modulus E·h";
    case Subject::poisson:
      return "Poisson's ratio";
    case Subject::C11:
    case Subject::C12:
      return "elastic constant of the sheet";
    case Subject::biaxial_stiffness:
      return "stiffness under equal strain both ways";
    case Subject::young:
      return "E·h over graphite's spacing of 3.35 Å";
    case Subject::third_zigzag:
    case Subject::third_armchair:
      return "D of S = E ε + D ε² (second Piola-Kirchhoff, Lagrangian strain), uniaxial, 1 to 5 %";
    case Subject::nominal_third_zigzag:
    case Subject::nominal_third_armchair:
      return "the same of nominal stress and elongation: D + 3/2 E";
    case Subject::strength_zigzag:
    case Subject::strength_armchair:
    case Subject::strength_equibiaxial:
      return "largest nominal stress, homogeneous, artefact of the cut-off included";
    case Subject::bending:
      return "bending modulus";
    case Subject::point_alpha:
      return "F a²/(E·h δ³), point load, no pretension; nu";
    case Subject::point_beta:
      return "dF/dN0/(π δ) at N0 = 0, point load; nu";
    case Subject::taut_disc:
      return "F/(N0 δ) of a taut sheet at small depth, disc load; nu, tip-ratio";
    case Subject::hencky:
      return "w0/a (E·h/(p a))^(1/3), clamped disc under pressure; nu";
    case Subject::figure:
      return "a number of one of the paper's figures; figure, number";
  }
  return {};
}

std::string_view base_unit_of(Subject subject) {
  switch (subject) {
    case Subject::lattice_constant:
      return unit::length;
    case Subject::young:
      return unit::stress;
    case Subject::bending:
      return unit::energy;
    case Subject::poisson:
    case Subject::point_alpha:
    case Subject::point_beta:
    case Subject::taut_disc:
    case Subject::hencky:
    case Subject::figure:
      return unit::none;
    default:
      return unit::membrane_force;
  }
}

}  // namespace validate::published
