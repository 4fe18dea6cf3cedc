// Name, unit and meaning of every member of the result structs that leaves the program: JSON keys, HDF5
// attributes and data sets, CSV headers. outputs/keys.hpp adds the unit to the name and the twins in N/m.
#pragma once

#include "compare/base/describe.hpp"
#include "compare/results/result.hpp"

namespace validate {

template <class Self, class Visitor>
requires SameStruct<Self, Fit>
void describe(Self& fit, Visitor&& visit) {
  visit(Field{"Eh", unit::membrane_force, "fitted sheet modulus"}, fit.Eh_eV_per_A2);
  visit(Field{"Eh_stderr", unit::membrane_force, "its standard error"}, fit.Eh_stderr_eV_per_A2);
  visit(Field{"pretension", unit::membrane_force, "fitted pretension"}, fit.pretension_eV_per_A2);
  visit(Field{"pretension_stderr", unit::membrane_force, "its standard error"}, fit.pretension_stderr_eV_per_A2);
  visit(Field{"correlation", unit::none, "correlation of sheet modulus and pretension"}, fit.correlation);
  visit(Field{"rms_relative", unit::none, "root mean square residual over the largest force"}, fit.rms_relative);
  visit(Field{"window", unit::length, "first and last depth fitted"}, fit.window_A);
  visit(Field{"points", unit::none, "number of points fitted"}, fit.points);
  visit(Field{"correlation_matrix", unit::none, "of all parameters, row by row: E·h, pretension, then the offsets"},
        fit.correlation_matrix);
  visit(Field{"r_squared", unit::none, "share of the forces' scatter that the fit explains"}, fit.r_squared);
  visit(Field{"condition_number", unit::none, "of the Jacobian with columns of equal length"}, fit.condition_number);
  visit(Field{"Eh_interval", unit::membrane_force, "95 % interval by profile likelihood"}, fit.Eh_interval_eV_per_A2);
  visit(Field{"pretension_interval", unit::membrane_force, "95 % interval by profile likelihood"},
        fit.pretension_interval_eV_per_A2);
  visit(Field{"Eh_bootstrap", unit::membrane_force, "standard error by residual bootstrap"},
        fit.Eh_bootstrap_eV_per_A2);
  visit(Field{"pretension_bootstrap", unit::membrane_force, "standard error by residual bootstrap"},
        fit.pretension_bootstrap_eV_per_A2);
  visit(Field{"warnings", unit::none, "what a careful reader would say of this fit"}, fit.warnings);
}

template <class Self, class Visitor>
requires SameStruct<Self, Fit>
void describe_points(Self& fit, Visitor&& visit) {
  visit(Field{"fitted_depth", unit::length, "depths of the points fitted"}, fit.fitted_depth_A);
  visit(Field{"residual", unit::force, "force minus the fitted curve there"}, fit.residual_eV_per_A);
}

template <class Self, class Visitor>
requires SameStruct<Self, FitBias>
void describe(Self& bias, Visitor&& visit) {
  visit(Field{"Eh_true", unit::membrane_force, "sheet modulus of the membrane"}, bias.Eh_true_eV_per_A2);
  visit(Field{"Eh_read", unit::membrane_force, "what the fit reads from that membrane"}, bias.Eh_read_eV_per_A2);
  visit(Field{"pretension_true", unit::membrane_force, "pretension of the membrane"}, bias.pretension_true_eV_per_A2);
  visit(Field{"pretension_read", unit::membrane_force, "what the fit reads from that membrane"},
        bias.pretension_read_eV_per_A2);
  visit(Field{"Eh_corrected", unit::membrane_force, "fitted sheet modulus × true / read"}, bias.Eh_corrected_eV_per_A2);
  visit(Field{"pretension_corrected", unit::membrane_force, "fitted pretension + true − read"},
        bias.pretension_corrected_eV_per_A2);
}

template <class Self, class Visitor>
requires SameStruct<Self, DirectFit>
void describe(Self& fit, Visitor&& visit) {
  visit(Field{"Eh", unit::membrane_force, "sheet modulus of the membrane that fits"}, fit.Eh_eV_per_A2);
  visit(Field{"Eh_stderr", unit::membrane_force, "its standard error"}, fit.Eh_stderr_eV_per_A2);
  visit(Field{"pretension", unit::membrane_force, "pretension of the membrane that fits"}, fit.pretension_eV_per_A2);
  visit(Field{"pretension_stderr", unit::membrane_force, "its standard error"}, fit.pretension_stderr_eV_per_A2);
  visit(Field{"rms_relative", unit::none, "root mean square residual over the largest force"}, fit.rms_relative);
}

template <class Self, class Visitor>
requires SameStruct<Self, WindowScan>
void describe_points(Self& scan, Visitor&& visit) {
  visit(Field{"depth_max", unit::length, "largest depth fitted"}, scan.depth_max_A);
  visit(Field{"Eh", unit::membrane_force, "sheet modulus fitted up to there"}, scan.Eh_eV_per_A2);
  visit(Field{"pretension", unit::membrane_force, "pretension fitted up to there"}, scan.pretension_eV_per_A2);
}

template <class Self, class Visitor>
requires SameStruct<Self, ContactSensitivity>
void describe(Self& contact, Visitor&& visit) {
  visit(Field{"force_change_relative", unit::none, "force at equal travel, contact four times stiffer"},
        contact.force_change_relative);
  visit(Field{"depth_change", unit::length, "depth of record at equal travel"}, contact.depth_change_A);
  visit(Field{"force_change_at_equal_depth_relative", unit::none, "force at equal depth of record"},
        contact.force_change_at_equal_depth_relative);
  visit(Field{"deepest_penetration", unit::length, "of an atom into the sphere, at the stiffness of the run"},
        contact.deepest_penetration_A);
}

/// What holds for the run as a whole.
template <class Self, class Visitor>
requires SameStruct<Self, Run>
void describe(Self& run, Visitor&& visit) {
  visit(Field{"model", unit::none, "membrane, atomistic or sheet (a membrane that resists bending)"}, run.model);
  visit(Field{"load", unit::none, "name of the load"}, run.load);
  if (run.constants != Constants::none) {
    visit(Field{"constants", unit::none,
                "where E·h and nu come from: card, paper, given; calibrated: the potential's own law"},
          run.constants);
  }
  visit(Field{"a", unit::length, "clamp radius as used"}, run.a_A);
  visit(Field{"tip", unit::length, "radius of the loaded disc or of the sphere as used"}, run.tip_A);
  visit(Field{"Eh", unit::membrane_force, "sheet modulus as used; for atoms the card's"}, run.Eh_eV_per_A2);
  visit(Field{"nu", unit::none, "Poisson's ratio as used; for atoms the card's"}, run.nu);
  visit(Field{"pretension", unit::membrane_force, "membrane force of the flat sheet"}, run.pretension_eV_per_A2);
  visit(Field{"record_radius", unit::length, "where the depth of record is taken; 0: the centre"}, run.record_radius_A);
  visit(Field{"ended", unit::none, "how the path ended"}, run.ended);
  visit(Field{"ended_reason", unit::none, "the same in words"}, run.ended_reason);
  if (run.model != Model::atomistic) {
    visit(Field{"triangles", unit::none, "triangles of the quarter's mesh; 0: solved in one dimension"}, run.triangles);
  }
}

/// One value per depth: the columns that the run's model has.
template <class Self, class Visitor>
requires SameStruct<Self, Run>
void describe_points(Self& run, Visitor&& visit) {
  visit(Field{"depth", unit::length, "depth of record"}, run.depth_A);
  visit(Field{"conjugate_depth", unit::length, "depth that is work-conjugate to the force"}, run.conjugate_depth_A);
  visit(Field{"force", unit::force, "total force on the full sheet"}, run.force_eV_per_A);
  visit(Field{"energy", unit::energy, "energy relative to the flat sheet"}, run.energy_eV);
  visit(Field{"converged", unit::none, "equilibrium reached"}, run.converged);
  if (run.model != Model::atomistic) {
    if (run.constants == Constants::calibrated)
      visit(Field{"longest_bond", unit::length, "longest bond, predicted from the strains"}, run.longest_bond_A);
    visit(Field{"newton_iterations", unit::none, "Newton iterations of this depth"}, run.newton_iterations);
    return;
  }
  visit(Field{"longest_bond", unit::length, "longest bond of the sheet"}, run.longest_bond_A);
  visit(Field{"artefact", unit::none, "longest bond in the potential's switching range"}, run.artefact);
  visit(Field{"max_force", unit::force, "largest force left on a free atom"}, run.max_force_eV_per_A);
  visit(Field{"balance_relative", unit::none, "tip force plus rim reaction, over the force"}, run.balance_relative);
  visit(Field{"force_error_relative", unit::none, "estimated error of the force, over the force"},
        run.force_error_relative);
  visit(Field{"force_evaluations", unit::none, "LAMMPS force computations for this depth"}, run.force_evaluations);
  visit(Field{"factorisations", unit::none, "preconditioner factorisations for this depth"}, run.factorisations);
}

template <class Self, class Visitor>
requires SameStruct<Self, CardSummary>
void describe(Self& card, Visitor&& visit) {
  visit(Field{"a0", unit::length, "lattice constant"}, card.a0_A);
  visit(Field{"energy_per_atom", unit::energy, "energy per atom of the flat sheet"}, card.energy_per_atom_eV);
  visit(Field{"C11", unit::membrane_force, "elastic constant"}, card.C11_eV_per_A2);
  visit(Field{"C12", unit::membrane_force, "elastic constant"}, card.C12_eV_per_A2);
  visit(Field{"C66", unit::membrane_force, "elastic constant"}, card.C66_eV_per_A2);
  visit(Field{"Eh", unit::membrane_force, "sheet modulus"}, card.Eh_eV_per_A2);
  visit(Field{"nu", unit::none, "Poisson's ratio"}, card.nu);
  visit(Field{"bending_modulus", unit::energy, "bending modulus"}, card.bending_modulus_eV);
  visit(Field{"isotropy_error", unit::none, "C66 / ((C11 − C12)/2) − 1"}, card.isotropy_error);
  visit(Field{"artefact_bond", unit::length, "longest bond from which on forces are an artefact"},
        card.artefact_bond_A);
}

template <class Self, class Visitor>
requires SameStruct<Self, LawSummary>
void describe(Self& law, Visitor&& visit) {
  visit(Field{"degree", unit::none, "of the energy in the strain"}, law.degree);
  visit(Field{"rms_misfit", unit::none, "of the stress, relative"}, law.rms_misfit);
  visit(Field{"worst_misfit", unit::none, "of the stress, relative"}, law.worst_misfit);
  visit(Field{"anisotropy", unit::none, "left out: largest difference of the stress along zigzag or armchair"},
        law.anisotropy);
  visit(Field{"longest_bond", unit::length, "up to which the law holds"}, law.longest_bond_A);
  visit(Field{"convex", unit::none, "up to there"}, law.convex);
  visit(Field{"bending_modulus", unit::energy, "that goes with it"}, law.bending_modulus_eV);
}

/// One value per term c I^a q^b of the energy per area, beyond the card's quadratic ones.
template <class Self, class Visitor>
requires SameStruct<Self, LawSummary>
void describe_points(Self& law, Visitor&& visit) {
  visit(Field{"power_of_I", unit::none, "a; I = E1 + E2, Green-Lagrange"}, law.power_of_I);
  visit(Field{"power_of_q", unit::none, "b; q = |E1 - E2|/2"}, law.power_of_q);
  visit(Field{"coefficient", unit::membrane_force, "c"}, law.coefficient_eV_per_A2);
}

template <class Self, class Visitor>
requires SameStruct<Self, Agreement>
void describe(Self& agreement, Visitor&& visit) {
  visit(Field{"load", unit::none, "load judged"}, agreement.load);
  visit(Field{"against", unit::none, "continuum that the atoms are compared with"}, agreement.against);
  visit(Field{"window", unit::none, "range judged, depth / effective radius"}, agreement.window);
  visit(Field{"max_relative_difference", unit::none, "largest |F_atoms / F_continuum − 1|"},
        agreement.max_relative_difference);
  visit(Field{"tolerance", unit::none, "largest difference that passes"}, agreement.tolerance);
  visit(Field{"passed", unit::none, "within the tolerance"}, agreement.passed);
}

/// One value per depth judged.
template <class Self, class Visitor>
requires SameStruct<Self, Agreement>
void describe_points(Self& agreement, Visitor&& visit) {
  visit(Field{"depth", unit::length, "atoms' depth of record"}, agreement.depth_A);
  visit(Field{"ratio", unit::none, "F_atoms / F_continuum at that depth"}, agreement.ratio);
}

template <class Self, class Visitor>
requires SameStruct<Self, Comparison>
void describe(Self& comparison, Visitor&& visit) {
  visit(Field{"load", unit::none, "load of both curves"}, comparison.load);
  visit(Field{"bending_to", unit::length, "up to this depth the force ratio is above 1 + tolerance"},
        comparison.bending_to_A);
  visit(Field{"softening_from", unit::length, "from this depth the force ratio is below 1 − tolerance"},
        comparison.softening_from_A);
  visit(Field{"artefact_from", unit::length, "first depth in the potential's artefact zone"},
        comparison.artefact_from_A);
  visit(Field{"predicted_artefact_from", unit::length, "where the calibrated sheet's strains put its beginning"},
        comparison.predicted_artefact_from_A);
}

/// One value per depth compared.
template <class Self, class Visitor>
requires SameStruct<Self, Comparison>
void describe_points(Self& comparison, Visitor&& visit) {
  visit(Field{"depth", unit::length, "atoms' depth of record"}, comparison.depth_A);
  visit(Field{"depth_relative", unit::none, "the same over the effective radius"}, comparison.depth_relative);
  visit(Field{"force_ratio", unit::none, "F_atoms / F_membrane at this depth"}, comparison.force_ratio);
  visit(Field{"depth_ratio", unit::none, "d_atoms / d_membrane at the atoms' force"}, comparison.depth_ratio);
  visit(Field{"energy_ratio", unit::none, "W_atoms / W_membrane at this depth"}, comparison.energy_ratio);
  visit(Field{"calibrated_membrane_ratio", unit::none, "F_atoms / F_calibrated membrane at this depth"},
        comparison.calibrated_membrane_ratio);
  visit(Field{"sheet_ratio", unit::none, "F_atoms / F_calibrated sheet with bending at this depth"},
        comparison.sheet_ratio);
  visit(Field{"regime", unit::none, "bending, membrane, softening or artefact"}, comparison.regime);
}

template <class Self, class Visitor>
requires SameStruct<Self, Explanation>
void describe(Self& explanation, Visitor&& visit) {
  visit(Field{"load", unit::none, "load explained"}, explanation.load);
}

/// One value per depth of the atoms: shares of the plain membrane's force.
template <class Self, class Visitor>
requires SameStruct<Self, Explanation>
void describe_points(Self& explanation, Visitor&& visit) {
  visit(Field{"depth", unit::length, "depth of record"}, explanation.depth_A);
  visit(Field{"depth_relative", unit::none, "the same over the effective radius"}, explanation.depth_relative);
  visit(Field{"plain_force", unit::force, "of the St Venant-Kirchhoff membrane with nominal radii"},
        explanation.plain_force_eV_per_A);
  visit(Field{"geometry", unit::none, "radii of clamp and tip as the atoms have them"}, explanation.geometry);
  visit(Field{"bending", unit::none, "resistance to bending"}, explanation.bending);
  visit(Field{"large_strain", unit::none, "the potential's own response at large strain"}, explanation.large_strain);
  visit(Field{"anisotropy", unit::none, "the lattice's directions"}, explanation.anisotropy);
  visit(Field{"remainder", unit::none, "what is left to the atoms' force"}, explanation.remainder);
}

template <class Self, class Visitor>
requires SameStruct<Self, SheetSummary>
void describe(Self& sheet, Visitor&& visit) {
  visit(Field{"radius", unit::length, "nominal radius of the free sheet"}, sheet.radius_A);
  visit(Field{"effective_radius", unit::length, "clamp radius of the paired continuum"}, sheet.effective_radius_A);
  visit(Field{"atoms", unit::none, "atoms, clamped ring included"}, sheet.atoms);
  visit(Field{"free_atoms", unit::none, "atoms that move"}, sheet.free_atoms);
  visit(Field{"loaded_disc_atoms", unit::none, "atoms that carry the disc load"}, sheet.loaded_disc_atoms);
}

template <class Self, class Visitor>
requires SameStruct<Self, Timing>
void describe(Self& timing, Visitor&& visit) {
  visit(Field{"wall", unit::second, "whole command"}, timing.wall_s);
  visit(Field{"membrane", unit::second, "membrane runs"}, timing.membrane_s);
  visit(Field{"atomistic", unit::second, "atomistic curves, without the card"}, timing.atomistic_s);
  visit(Field{"setup", unit::second, "LAMMPS's start and the first force of each depth with its set-up"},
        timing.setup_s);
  visit(Field{"factor", unit::second, "factorising the preconditioner"}, timing.factor_s);
  visit(Field{"solve", unit::second, "solving with the preconditioner"}, timing.solve_s);
  visit(Field{"force_calls", unit::none, "LAMMPS force computations of all curves"}, timing.force_calls);
  visit(Field{"force", unit::second, "inside LAMMPS's force computation, summed over curves"}, timing.force_s);
}

template <class Self, class Visitor>
requires SameStruct<Self, Unloading>
void describe(Self& unloading, Visitor&& visit) {
  visit(Field{"load", unit::none, "name of the load"}, unloading.load);
  visit(Field{"hysteresis_relative", unit::none, "work lost there and back, over the work put in"},
        unloading.hysteresis_relative);
  visit(Field{"depth", unit::length, "depth of record on the way back"}, unloading.depth_A);
  visit(Field{"conjugate_depth", unit::length, "depth that is work-conjugate to the force"},
        unloading.conjugate_depth_A);
  visit(Field{"force", unit::force, "total force on the full sheet"}, unloading.force_eV_per_A);
}

template <class Self, class Visitor>
requires SameStruct<Self, Provenance>
void describe(Self& provenance, Visitor&& visit) {
  visit(Field{"version", unit::none, "version of validate"}, provenance.version);
  visit(Field{"git", unit::none, "git revision of the sources"}, provenance.git);
  visit(Field{"lammps", unit::none, "LAMMPS version"}, provenance.lammps);
  visit(Field{"gsl", unit::none, "GSL version"}, provenance.gsl);
  visit(Field{"hdf5", unit::none, "HDF5 version"}, provenance.hdf5);
  visit(Field{"suitesparse", unit::none, "SuiteSparse version"}, provenance.suitesparse);
  visit(Field{"blas", unit::none, "BLAS library loaded"}, provenance.blas);
  visit(Field{"potential_file", unit::none, "the potential's parameter file"}, provenance.potential_file);
  visit(Field{"potential_sha256", unit::none, "its SHA-256"}, provenance.potential_sha256);
  visit(Field{"potential_edit", unit::none, "what was changed in a copy of it"}, provenance.potential_edit);
  visit(Field{"command_line", unit::none, "the command that made this"}, provenance.command_line);
}

}  // namespace validate
