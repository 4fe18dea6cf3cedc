#include "compare/documents/texts/card_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/base/errors.hpp"
#include "compare/base/file.hpp"
#include "compare/base/units.hpp"
#include "compare/documents/plots/draw.hpp"
#include "compare/documents/plots/stress_strain.hpp"
#include "compare/documents/texts/law_toml.hpp"
#include "compare/potential/law/states.hpp"
#include "compare/potential/law/variants.hpp"
#include "compare/process/provenance.hpp"

namespace validate {
namespace {

using Json = nlohmann::ordered_json;

/// A membrane force under its name in both units.
void add_both(Json& object, const std::string& name, double eV_per_A2) {
  const bool known = std::isfinite(eV_per_A2);
  object[name + "_eV_per_A2"] = known ? Json(eV_per_A2) : Json(nullptr);
  object[name + "_N_per_m"] = known ? Json(eV_per_A2 * N_per_m_per_eV_per_A2) : Json(nullptr);
}

Json curve_document(const atomistic::StressCurve& c) {
  Json j{{"direction", c.direction}};
  add_both(j, "secant_at_2_percent", c.secant_2_eV_per_A2);
  add_both(j, "secant_at_5_percent", c.secant_5_eV_per_A2);
  add_both(j, "secant_at_10_percent", c.secant_10_eV_per_A2);
  add_both(j, "strength", c.strength_eV_per_A2);
  j["strain_at_strength"] = c.strain_at_strength;
  j["artefact_strain"] = c.artefact_strain ? Json(*c.artefact_strain) : Json(nullptr);
  j["strain"] = c.strain;
  j["lateral_strain"] = c.lateral_strain;
  j["stress_eV_per_A2"] = c.stress_eV_per_A2;
  j["longest_bond_A"] = c.longest_bond_A;
  return j;
}

Json state_document(const atomistic::HomogeneousState& s) {
  return {{"E11", s.strain.E11},
          {"E22", s.strain.E22},
          {"E12", s.strain.E12},
          {"orientation_deg", s.strain.orientation_deg},
          {"S11_eV_per_A2", s.S11_eV_per_A2},
          {"S22_eV_per_A2", s.S22_eV_per_A2},
          {"S12_eV_per_A2", s.S12_eV_per_A2},
          {"energy_eV_per_A2", s.energy_eV_per_A2},
          {"longest_bond_A", s.longest_bond_A},
          {"shift_A", {s.shift_x_A, s.shift_y_A}},
          {"converged", s.converged}};
}

Json law_document(const CalibratedLaw& c) {
  Json j{{"degree", c.degree}, {"terms", Json::array()}, {"states_fitted", 0}};
  for (std::size_t k = 0; k < c.law.terms.size(); ++k) {
    const auto& term = c.law.terms[k];
    j["terms"].push_back({{"a", term.a},
                          {"b", term.b},
                          {"coefficient_eV_per_A2", term.coefficient_eV_per_A2},
                          {"stderr_eV_per_A2", c.standard_errors_eV_per_A2[k]}});
  }
  j["states_fitted"] = std::ranges::count_if(c.states, &CalibratedState::fitted);
  j["condition_number"] = c.condition_number;
  j["rms_misfit"] = c.rms_misfit;
  j["worst_misfit"] = c.worst_misfit;
  j["anisotropy"] = c.anisotropy;
  j["smallest_strain"] = c.smallest_strain;
  j["longest_bond_A"] = longest_calibrated_bond_A;
  j["convex"] = c.convexity.convex();
  j["smallest_tangent_eV_per_A2"] = c.convexity.smallest_eigenvalue_eV_per_A2;
  j["smallest_tangent_at"] = {c.convexity.E1, c.convexity.E2};
  Json bond{{"rest_A", c.longest_bond.rest_A}, {"terms", Json::array()}};
  for (const auto& term : c.longest_bond.terms)
    bond["terms"].push_back({{"a", term.a}, {"b", term.b}, {"coefficient_A", term.coefficient_A}});
  bond["worst_misfit_A"] = c.longest_bond.worst_misfit_A;
  j["longest_bond"] = bond;
  return j;
}

/// The forms that a law can take, and whether a force would notice.
std::string variant_lines(const PotentialCard& p) {
  std::string text = "\n  form      coefficients   misfit rms   worst   force under a disc of 10 Å on 110 Å\n";
  for (const LawVariant& v : law_variants(p.card, p.response.states))
    text += fmt::format("  {:10}{:12}{:11.3f} %{:7.2f} %   {:.3f} % from {}\n", v.name, v.coefficients,
                        100 * v.rms_misfit, 100 * v.worst_misfit, 100 * v.force_difference,
                        v.name == "sixfold" ? "degree 8"
                        : v.name == "table" ? "itself"
                                            : "the table");
  return text;
}

std::string law_lines(const PotentialCard& p) {
  if (!p.law) return fmt::format("\nno calibrated law: {}\n", p.no_law);
  const CalibratedLaw& c = *p.law;
  std::string text = fmt::format(
      "\ncalibrated law, degree {}: {} coefficients from {} states at 15° to zigzag, bonds up to {:.2f} Å\n", c.degree,
      c.law.terms.size(), std::ranges::count_if(c.states, &CalibratedState::fitted), longest_calibrated_bond_A);
  const auto line = [&](std::string_view name, const std::string& value) {
    text += fmt::format("  {:26}{}\n", name, value);
  };
  line("stress misfit", fmt::format("{:.2f} % rms, {:.2f} % at worst", 100 * c.rms_misfit, 100 * c.worst_misfit));
  line("anisotropy left out", fmt::format("up to {:.1f} % in stress along zigzag or armchair", 100 * c.anisotropy));
  line("longest bond", fmt::format("from the strain within {:.4f} Å", c.longest_bond.worst_misfit_A));
  line(c.convexity.convex() ? "convex in its range" : "NOT convex in its range",
       fmt::format("smallest stiffness {:.3f} eV/Å² at E1 = {:.3f}, E2 = {:.3f}",
                   c.convexity.smallest_eigenvalue_eV_per_A2, c.convexity.E1, c.convexity.E2));
  return text + variant_lines(p);
}

std::string csv(const PotentialCard& card) {
  std::string text = fmt::format(
      "# potential: {}\n# nominal stress (first Piola-Kirchhoff membrane force) over nominal strain, T = 0\n"
      "direction,strain,lateral_strain,stress_eV_per_A2,stress_N_per_m,longest_bond_A\n",
      card.potential.potential.name);
  for (const atomistic::StressCurve& c : card.response.curves)
    for (std::size_t k = 0; k < c.strain.size(); ++k)
      text += fmt::format("{},{},{},{},{},{}\n", c.direction, c.strain[k], c.lateral_strain[k], c.stress_eV_per_A2[k],
                          c.stress_eV_per_A2[k] * N_per_m_per_eV_per_A2, c.longest_bond_A[k]);
  return text;
}

std::string curve_lines(const atomistic::StressCurve& c) {
  const auto shown = [](double eV_per_A2) { return fmt::format("{:8.1f}", eV_per_A2 * N_per_m_per_eV_per_A2); };
  return fmt::format("{:12}{}{}{}{}   {:6.1f} %  {}\n", c.direction, shown(c.secant_2_eV_per_A2),
                     shown(c.secant_5_eV_per_A2), shown(c.secant_10_eV_per_A2), shown(c.strength_eV_per_A2),
                     100 * c.strain_at_strength,
                     c.artefact_strain ? fmt::format("{:.1f} %", 100 * *c.artefact_strain) : std::string("not met"));
}

}  // namespace

nlohmann::ordered_json card_document(const PotentialCard& p) {
  const atomistic::Card& card = p.card;
  Json j;
  j["schema"] = 1;
  j["potential"] = {{"name", p.potential.potential.name},
                    {"description", p.potential.potential.description},
                    {"citation", p.potential.potential.citation},
                    {"file", p.potential.potential.file.empty() ? Json(nullptr) : Json(p.potential.potential.file)},
                    {"sha256", p.potential.sha256.empty() ? Json(nullptr) : Json(p.potential.sha256)},
                    {"edit", p.potential.edit.empty() ? Json(nullptr) : Json(p.potential.edit)},
                    {"artefact_bond_A", p.potential.potential.artefact_bond_A}};
  j["a0_A"] = card.a0_A;
  j["energy_per_atom_eV"] = card.energy_per_atom_eV;
  add_both(j, "C11", card.C11_eV_per_A2);
  add_both(j, "C12", card.C12_eV_per_A2);
  add_both(j, "C66", card.C66_eV_per_A2);
  j["isotropy_error"] = card.C66_eV_per_A2 / ((card.C11_eV_per_A2 - card.C12_eV_per_A2) / 2) - 1;
  add_both(j, "Eh", card.sheet_modulus_eV_per_A2());
  j["nu"] = card.nu();
  j["bending_modulus_zigzag_eV"] = card.bending_modulus_zigzag_eV;
  j["bending_modulus_armchair_eV"] = card.bending_modulus_armchair_eV;
  j["bending_method"] = "out-of-plane stiffness of long ripples in the flat sheet, extrapolated in the wave number";
  j["gaussian_modulus_eV"] = nullptr;  // a ripple is a developable shape: it does not see it
  j["curves"] = Json::array();
  for (const auto& c : p.response.curves) j["curves"].push_back(curve_document(c));
  j["states"] = Json::array();
  for (const auto& s : p.response.states) j["states"].push_back(state_document(s));
  j["law"] = p.law ? law_document(*p.law) : Json(nullptr);
  if (!p.law) j["law_missing"] = p.no_law;
  j["lammps"] = p.lammps;
  return j;
}

std::string card_table(const PotentialCard& p) {
  const atomistic::Card& card = p.card;
  std::string text = fmt::format("{}: {}\n  {}\n\n", p.potential.potential.name, p.potential.potential.description,
                                 p.potential.potential.citation);
  const auto line = [&](std::string_view name, const std::string& value) {
    text += fmt::format("  {:26}{}\n", name, value);
  };
  const auto both = [](double x) { return fmt::format("{:9.2f} N/m  {:9.4f} eV/Å²", x * N_per_m_per_eV_per_A2, x); };
  line("lattice constant", fmt::format("{:.6f} Å", card.a0_A));
  line("energy per atom", fmt::format("{:.5f} eV", card.energy_per_atom_eV));
  line("C11", both(card.C11_eV_per_A2));
  line("C12", both(card.C12_eV_per_A2));
  line("C66 / ((C11−C12)/2) − 1",
       fmt::format("{:.2f} %", 100 * (card.C66_eV_per_A2 / ((card.C11_eV_per_A2 - card.C12_eV_per_A2) / 2) - 1)));
  line("sheet modulus E·h", both(card.sheet_modulus_eV_per_A2()));
  line("Poisson's ratio", fmt::format("{:.4f}", card.nu()));
  line("bending modulus", fmt::format("{:.4f} eV (zigzag)  {:.4f} eV (armchair)", card.bending_modulus_zigzag_eV,
                                      card.bending_modulus_armchair_eV));
  line("artefact from a bond of", fmt::format("{:.2f} Å", p.potential.potential.artefact_bond_A));
  if (!p.potential.edit.empty()) line("edited", p.potential.edit);
  text +=
      "\n            secant modulus, N/m, at    strength   at strain  artefact from\n"
      "                 2 %     5 %    10 %      N/m\n";
  for (const auto& c : p.response.curves) text += curve_lines(c);
  return text + law_lines(p);
}

std::optional<std::string> write_card_files(const PotentialCard& card, const std::filesystem::path& folder) {
  write_file(folder / "card.json", card_document(card).dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
  write_file(folder / "stress-strain.csv", csv(card));
  if (card.law) write_file(folder / "law.toml", law_toml(card));
  return draw(stress_strain_plot(card), folder, "stress-strain");  // stress-strain.csv holds more than is drawn
}

}  // namespace validate
