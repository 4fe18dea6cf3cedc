#include "compare/study/summaries.hpp"

#include <algorithm>

#include "atomistic/loads/load_term.hpp"
#include "compare/potential/law/variants.hpp"
#include "compare/process/provenance.hpp"

namespace validate {
namespace {

CardSummary summary_of(const PotentialCard& p) {
  const atomistic::Card& card = p.card;
  const double isotropic = (card.C11_eV_per_A2 - card.C12_eV_per_A2) / 2;
  return {.a0_A = card.a0_A,
          .energy_per_atom_eV = card.energy_per_atom_eV,
          .C11_eV_per_A2 = card.C11_eV_per_A2,
          .C12_eV_per_A2 = card.C12_eV_per_A2,
          .C66_eV_per_A2 = card.C66_eV_per_A2,
          .Eh_eV_per_A2 = card.sheet_modulus_eV_per_A2(),
          .nu = card.nu(),
          .bending_modulus_eV = card.bending_modulus_eV(),
          .bending_modulus_zigzag_eV = card.bending_modulus_zigzag_eV,
          .bending_modulus_armchair_eV = card.bending_modulus_armchair_eV,
          .bending_method = "out-of-plane stiffness of long ripples in the flat sheet, extrapolated in the wave number",
          .isotropy_error = card.C66_eV_per_A2 / isotropic - 1,
          .artefact_bond_A = p.potential.potential.artefact_bond_A,
          .lammps = p.lammps};
}

BondTerms summary_of(const LongestBond& bond) {
  BondTerms summary;
  summary.rest_A = bond.rest_A;
  summary.worst_misfit_A = bond.worst_misfit_A;
  for (const LongestBond::Term& term : bond.terms) {
    summary.power_of_I.push_back(term.a);
    summary.power_of_q.push_back(term.b);
    summary.coefficient_A.push_back(term.coefficient_A);
  }
  return summary;
}

LawSummary summary_of(const CalibratedLaw& law, double bending_modulus_eV) {
  LawSummary summary;
  summary.degree = law.degree;
  summary.states_fitted = static_cast<int>(std::ranges::count_if(law.states, &CalibratedState::fitted));
  summary.condition_number = law.condition_number;
  summary.rms_misfit = law.rms_misfit;
  summary.worst_misfit = law.worst_misfit;
  summary.anisotropy = law.anisotropy;
  summary.smallest_strain = law.smallest_strain;
  summary.longest_bond_A = law.range.holds_A;
  summary.convex = law.convexity.convex();
  summary.smallest_tangent_eV_per_A2 = law.convexity.smallest_eigenvalue_eV_per_A2;
  summary.smallest_tangent_at = {law.convexity.E1, law.convexity.E2};
  summary.bending_modulus_eV = bending_modulus_eV;
  summary.coefficient_stderr_eV_per_A2 = law.standard_errors_eV_per_A2;
  summary.bond = summary_of(law.longest_bond);
  for (const membrane::InvariantTerm& term : law.law.terms) {
    summary.power_of_I.push_back(term.a);
    summary.power_of_q.push_back(term.b);
    summary.coefficient_eV_per_A2.push_back(term.coefficient_eV_per_A2);
  }
  return summary;
}

/// Of the curve's points before the artefact length is reached: the first one beyond is the cut-off's already.
std::optional<double> largest_before_artefact(const atomistic::StressCurve& c) {
  if (!c.artefact_strain) return std::nullopt;
  double largest = 0;
  for (std::size_t k = 0; k < c.strain.size() && c.strain[k] < *c.artefact_strain; ++k)
    largest = std::max(largest, c.stress_eV_per_A2[k]);
  return largest;
}

StressCurve summary_of(const atomistic::StressCurve& c) {
  return {.direction = c.direction,
          .secant_2_eV_per_A2 = c.secant_2_eV_per_A2,
          .secant_5_eV_per_A2 = c.secant_5_eV_per_A2,
          .secant_10_eV_per_A2 = c.secant_10_eV_per_A2,
          .strength_eV_per_A2 = c.strength_eV_per_A2,
          .strain_at_strength = c.strain_at_strength,
          .strength_is_artefact = c.artefact_strain && *c.artefact_strain < c.strain_at_strength,
          .artefact_strain = c.artefact_strain,
          .largest_before_artefact_eV_per_A2 = largest_before_artefact(c),
          .strain = c.strain,
          .lateral_strain = c.lateral_strain,
          .stress_eV_per_A2 = c.stress_eV_per_A2,
          .longest_bond_A = c.longest_bond_A};
}

StrainStates summary_of(const std::vector<atomistic::HomogeneousState>& states) {
  StrainStates all;
  for (const atomistic::HomogeneousState& s : states) {
    all.E11.push_back(s.strain.E11);
    all.E22.push_back(s.strain.E22);
    all.E12.push_back(s.strain.E12);
    all.orientation_deg.push_back(s.strain.orientation_deg);
    all.S11_eV_per_A2.push_back(s.S11_eV_per_A2);
    all.S22_eV_per_A2.push_back(s.S22_eV_per_A2);
    all.S12_eV_per_A2.push_back(s.S12_eV_per_A2);
    all.energy_eV_per_A2.push_back(s.energy_eV_per_A2);
    all.longest_bond_A.push_back(s.longest_bond_A);
    all.shift_x_A.push_back(s.shift_x_A);
    all.shift_y_A.push_back(s.shift_y_A);
    all.converged.push_back(s.converged);
  }
  return all;
}

std::vector<LawForm> forms_of(const PotentialCard& card) {
  std::vector<LawForm> forms;
  for (const LawVariant& v : law_variants(card.card, card.response.states, card.law->range))
    forms.push_back({v.name, static_cast<int>(v.coefficients), v.rms_misfit, v.worst_misfit, v.force_difference,
                     v.name == "sixfold" ? "degree 8"
                     : v.name == "table" ? "itself"
                                         : "the table"});
  return forms;
}

}  // namespace

void summarise(const PotentialCard& card, Result& result) {
  result.card = summary_of(card);
  if (card.law) result.law = summary_of(*card.law, card.card.bending_modulus_eV());
  result.law_missing = card.no_law;
  result.provenance.lammps = card.lammps;
}

Result potential_result(const PotentialCard& card) {
  Result result;
  result.command = Command::potential;
  result.provenance = provenance(command_line());
  const atomistic::Potential& p = card.potential.potential;
  result.potential = {p.name,           p.description, p.citation, p.file, card.potential.sha256, card.potential.edit,
                      p.artefact_bond_A};
  summarise(card, result);
  for (const atomistic::StressCurve& curve : card.response.curves) result.stress_curves.push_back(summary_of(curve));
  result.states = summary_of(card.response.states);
  if (card.law) result.law_forms = forms_of(card);
  return result;
}

SheetSummary summary_of(const Case& c, const PairedSheet& pair) {
  return {.radius_A = c.radius_A,
          .effective_radius_A = pair.effective_radius_A(),
          .slope_margin_A = pair.slope_margin_A(),
          .clamp_radius_error_A = pair.clamp_radius_error_A(),
          .slope_margin_error_A = pair.slope_margin_error_A(),
          .tip_radius_error_A = pair.tip_radius_error_A(),
          .atoms = pair.sheet().atoms(),
          .free_atoms = pair.sheet().free_atoms,
          .loaded_disc_atoms = static_cast<int>(atomistic::atoms_within(pair.sheet(), c.tip_radius_A).size())};
}

}  // namespace validate
