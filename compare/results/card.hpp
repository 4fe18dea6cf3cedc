// What a potential says of flat graphene at T = 0: constants, stress under large homogeneous strain, and the law made
// from it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "compare/base/describe.hpp"
#include "compare/results/known.hpp"

namespace validate {

/// Which potential, and how it is described.
struct PotentialSummary {
  std::string name, description, citation;
  std::string file, sha256, edit;  ///< empty: none
  double artefact_bond_A = not_known;
};

void describe(SameStruct<PotentialSummary> auto& potential, auto&& visit) {
  visit(Field{"name", unit::none, "name of the potential"}, potential.name);
  visit(Field{"description", unit::none, "what it is"}, potential.description);
  visit(Field{"citation", unit::none, "where it was published"}, potential.citation);
  visit(Field{"file", unit::none, "its parameter file"}, potential.file);
  visit(Field{"sha256", unit::none, "of that file"}, potential.sha256);
  visit(Field{"edit", unit::none, "what was changed in a copy of it"}, potential.edit);
  visit(Field{"artefact_bond", unit::length, "longest bond from which on forces are an artefact"},
        potential.artefact_bond_A);
}

/// Linear response (T = 0, flat, relaxed inside the cell).
struct CardSummary {
  double a0_A = not_known, energy_per_atom_eV = not_known;
  double C11_eV_per_A2 = not_known, C12_eV_per_A2 = not_known, C66_eV_per_A2 = not_known;
  double Eh_eV_per_A2 = not_known, nu = not_known;
  double bending_modulus_eV = not_known;  ///< mean of the two below
  double bending_modulus_zigzag_eV = not_known, bending_modulus_armchair_eV = not_known;
  std::string bending_method;
  double gaussian_modulus_eV = not_known;  ///< a ripple is a developable shape: it does not see it
  double isotropy_error = not_known;       ///< C66 / ((C11 − C12)/2) − 1
  double artefact_bond_A = not_known;  ///< from this longest bond on, the potential's cut-off makes forces an artefact
  std::string lammps;                  ///< release that computed it
};

void describe(SameStruct<CardSummary> auto& card, auto&& visit) {
  visit(Field{"a0", unit::length, "lattice constant"}, card.a0_A);
  visit(Field{"energy_per_atom", unit::energy, "energy per atom of the flat sheet"}, card.energy_per_atom_eV);
  visit(Field{"C11", unit::membrane_force, "elastic constant"}, card.C11_eV_per_A2);
  visit(Field{"C12", unit::membrane_force, "elastic constant"}, card.C12_eV_per_A2);
  visit(Field{"C66", unit::membrane_force, "elastic constant"}, card.C66_eV_per_A2);
  visit(Field{"Eh", unit::membrane_force, "sheet modulus"}, card.Eh_eV_per_A2);
  visit(Field{"nu", unit::none, "Poisson's ratio"}, card.nu);
  visit(Field{"bending_modulus", unit::energy, "bending modulus"}, card.bending_modulus_eV);
  visit(Field{"bending_modulus_zigzag", unit::energy, "of a ripple along zigzag"}, card.bending_modulus_zigzag_eV);
  visit(Field{"bending_modulus_armchair", unit::energy, "of a ripple along armchair"},
        card.bending_modulus_armchair_eV);
  visit(Field{"bending_method", unit::none, "how it was found"}, card.bending_method);
  visit(Field{"gaussian_modulus", unit::energy, "of the Gaussian curvature; not known"}, card.gaussian_modulus_eV);
  visit(Field{"isotropy_error", unit::none, "C66 / ((C11 − C12)/2) − 1"}, card.isotropy_error);
  visit(Field{"artefact_bond", unit::length, "longest bond from which on forces are an artefact"},
        card.artefact_bond_A);
  visit(Field{"lammps", unit::none, "LAMMPS release that computed it"}, card.lammps);
}

/// A curve of nominal stress (first Piola–Kirchhoff membrane force) against nominal strain.
struct StressCurve {
  std::string direction;  ///< zigzag, armchair (uniaxial stress), equibiaxial
  double secant_2_eV_per_A2 = not_known, secant_5_eV_per_A2 = not_known, secant_10_eV_per_A2 = not_known;
  double strength_eV_per_A2 = not_known, strain_at_strength = not_known;
  bool strength_is_artefact = false;  ///< a bond is beyond the artefact length there: the cut-off's, not carbon's
  std::optional<double> artefact_strain, largest_before_artefact_eV_per_A2;
  std::vector<double> strain, lateral_strain, stress_eV_per_A2, longest_bond_A;
};

void describe(SameStruct<StressCurve> auto& curve, auto&& visit) {
  visit(Field{"direction", unit::none, "zigzag, armchair (uniaxial stress) or equibiaxial"}, curve.direction);
  visit(Field{"secant_at_2_percent", unit::membrane_force, "stress over strain at 2 %"}, curve.secant_2_eV_per_A2);
  visit(Field{"secant_at_5_percent", unit::membrane_force, "stress over strain at 5 %"}, curve.secant_5_eV_per_A2);
  visit(Field{"secant_at_10_percent", unit::membrane_force, "stress over strain at 10 %"}, curve.secant_10_eV_per_A2);
  visit(Field{"strength", unit::membrane_force, "largest stress"}, curve.strength_eV_per_A2);
  visit(Field{"strain_at_strength", unit::none, "largest stable strain under held force"}, curve.strain_at_strength);
  visit(Field{"strength_is_artefact", unit::none,
              "the strength lies beyond the potential's artefact length: it is the cut-off's"},
        curve.strength_is_artefact);
  visit(
      Field{
          "largest_before_artefact", unit::membrane_force,
          "largest stress before the artefact length, which the strength is not below; null where that is not reached"},
      curve.largest_before_artefact_eV_per_A2);
  visit(Field{"artefact_strain", unit::none, "where the longest bond reaches the potential's artefact length"},
        curve.artefact_strain);
  visit(Column{"strain", unit::none, "nominal strain"}, curve.strain);
  visit(Column{"lateral_strain", unit::none, "nominal strain across"}, curve.lateral_strain);
  visit(Column{"stress", unit::membrane_force, "nominal stress"}, curve.stress_eV_per_A2);
  visit(Column{"longest_bond", unit::length, "longest bond"}, curve.longest_bond_A);
}

/// The answer to homogeneous Green–Lagrange strains in axes turned from zigzag, second Piola–Kirchhoff; a column per
/// number.
struct StrainStates {
  std::vector<double> E11, E22, E12, orientation_deg, S11_eV_per_A2, S22_eV_per_A2, S12_eV_per_A2, energy_eV_per_A2;
  std::vector<double> longest_bond_A, shift_x_A, shift_y_A;
  std::vector<bool> converged;
};

void describe(SameStruct<StrainStates> auto& states, auto&& visit) {
  visit(Column{"E11", unit::none, "Green-Lagrange strain"}, states.E11);
  visit(Column{"E22", unit::none, "Green-Lagrange strain"}, states.E22);
  visit(Column{"E12", unit::none, "Green-Lagrange strain"}, states.E12);
  visit(Column{"orientation_deg", unit::none, "of the axes, from zigzag, degrees"}, states.orientation_deg);
  visit(Column{"S11", unit::membrane_force, "second Piola-Kirchhoff"}, states.S11_eV_per_A2);
  visit(Column{"S22", unit::membrane_force, "second Piola-Kirchhoff"}, states.S22_eV_per_A2);
  visit(Column{"S12", unit::membrane_force, "second Piola-Kirchhoff"}, states.S12_eV_per_A2);
  visit(Column{"energy", unit::membrane_force, "per reference area, from the sheet at rest"}, states.energy_eV_per_A2);
  visit(Column{"longest_bond", unit::length, "longest bond"}, states.longest_bond_A);
  visit(Column{"shift_x", unit::length, "inner displacement of a sublattice, along zigzag"}, states.shift_x_A);
  visit(Column{"shift_y", unit::length, "inner displacement of a sublattice, along armchair"}, states.shift_y_A);
  visit(Column{"converged", unit::none, "the sublattices found their place"}, states.converged);
}

/// The longest bond as a polynomial in the strains, one value per term.
struct BondTerms {
  double rest_A = not_known, worst_misfit_A = not_known;
  std::vector<int> power_of_I, power_of_q;
  std::vector<double> coefficient_A;
};

void describe(SameStruct<BondTerms> auto& bond, auto&& visit) {
  visit(Field{"rest", unit::length, "of the sheet at rest"}, bond.rest_A);
  visit(Field{"worst_misfit", unit::length, "largest error over the states"}, bond.worst_misfit_A);
  visit(Column{"power_of_I", unit::none, "a; I = E1 + E2, Green-Lagrange"}, bond.power_of_I);
  visit(Column{"power_of_q", unit::none, "b; q = |E1 - E2|/2"}, bond.power_of_q);
  visit(Column{"coefficient", unit::length, "c of the term c I^a q^b"}, bond.coefficient_A);
}

/// The law made from the potential's homogeneous response, as used: terms c I^a q^b of the energy per area, beyond the
/// card's quadratic ones.
struct LawSummary {
  int degree = 0, states_fitted = 0;
  double condition_number = not_known;
  double rms_misfit = not_known, worst_misfit = not_known;  ///< of the stress
  double anisotropy = not_known;  ///< left out: largest difference of the stress along zigzag or armchair
  double smallest_strain = not_known;
  double longest_bond_A = not_known;  ///< the law holds up to here
  bool convex = false;                ///< up to there
  double smallest_tangent_eV_per_A2 = not_known;
  std::array<double, 2> smallest_tangent_at{not_known, not_known};  ///< E1, E2
  double bending_modulus_eV = not_known;
  std::vector<int> power_of_I, power_of_q;
  std::vector<double> coefficient_eV_per_A2, coefficient_stderr_eV_per_A2;
  BondTerms bond;
};

void describe(SameStruct<LawSummary> auto& law, auto&& visit) {
  visit(Field{"degree", unit::none, "of the energy in the strain"}, law.degree);
  visit(Field{"states_fitted", unit::none, "homogeneous strains that the terms are fitted to"}, law.states_fitted);
  visit(Field{"condition_number", unit::none, "of that fit"}, law.condition_number);
  visit(Field{"rms_misfit", unit::none, "of the stress, relative"}, law.rms_misfit);
  visit(Field{"worst_misfit", unit::none, "of the stress, relative"}, law.worst_misfit);
  visit(Field{"anisotropy", unit::none, "left out: largest difference of the stress along zigzag or armchair"},
        law.anisotropy);
  visit(Field{"smallest_strain", unit::none, "from which the anisotropy counts"}, law.smallest_strain);
  visit(Field{"longest_bond", unit::length, "up to which the law holds"}, law.longest_bond_A);
  visit(Field{"convex", unit::none, "up to there"}, law.convex);
  visit(Field{"smallest_tangent", unit::membrane_force, "smallest eigenvalue of the tangent up to there"},
        law.smallest_tangent_eV_per_A2);
  visit(Field{"smallest_tangent_at", unit::none, "principal Green-Lagrange strains of that place"},
        law.smallest_tangent_at);
  visit(Field{"bending_modulus", unit::energy, "that goes with it"}, law.bending_modulus_eV);
  visit(Column{"power_of_I", unit::none, "a; I = E1 + E2, Green-Lagrange"}, law.power_of_I);
  visit(Column{"power_of_q", unit::none, "b; q = |E1 - E2|/2"}, law.power_of_q);
  visit(Column{"coefficient", unit::membrane_force, "c"}, law.coefficient_eV_per_A2);
  visit(Column{"coefficient_stderr", unit::membrane_force, "its standard error"}, law.coefficient_stderr_eV_per_A2);
  visit(Field{"bond", unit::none, "longest bond by the strains"}, law.bond);
}

/// A form that the law can take, how well it gives the lattice's membrane forces, and how far a disc of 10 Å on a sheet
/// of 110 Å feels the difference from the form it is compared with.
struct LawForm {
  std::string name;
  int coefficients = 0;
  double rms_misfit = not_known, worst_misfit = not_known;
  double force_difference = not_known;
  std::string compared_with;
};

void describe(SameStruct<LawForm> auto& form, auto&& visit) {
  visit(Field{"name", unit::none, "degree of the polynomial, table or sixfold"}, form.name);
  visit(Field{"coefficients", unit::none, "how many"}, form.coefficients);
  visit(Field{"rms_misfit", unit::none, "of the stress, relative"}, form.rms_misfit);
  visit(Field{"worst_misfit", unit::none, "of the stress, relative"}, form.worst_misfit);
  visit(Field{"force_difference", unit::none, "largest relative one under a disc of 10 Å on a sheet of 110 Å"},
        form.force_difference);
  visit(Field{"compared_with", unit::none, "form that this is the difference from"}, form.compared_with);
}

}  // namespace validate
