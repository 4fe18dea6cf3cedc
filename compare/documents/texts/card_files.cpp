#include "compare/documents/texts/card_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/base/errors.hpp"
#include "compare/base/file.hpp"
#include "compare/base/units.hpp"
#include "compare/documents/bytes/run_h5.hpp"
#include "compare/documents/plots/draw.hpp"
#include "compare/documents/plots/stress_strain.hpp"
#include "compare/documents/texts/json.hpp"
#include "compare/documents/texts/law_toml.hpp"
#include "compare/documents/texts/thermal_text.hpp"

namespace validate {
namespace {

/// The forms that a law can take, and whether a force would notice.
std::string form_lines(const std::vector<LawForm>& forms) {
  std::string text = "\n  form      coefficients   misfit rms   worst   force under a disc of 10 Å on 110 Å\n";
  for (const LawForm& form : forms)
    text +=
        fmt::format("  {:10}{:12}{:11.3f} %{:7.2f} %   {:.3f} % from {}\n", form.name, form.coefficients,
                    100 * form.rms_misfit, 100 * form.worst_misfit, 100 * form.force_difference, form.compared_with);
  return text;
}

std::string law_lines(const Result& r) {
  if (!r.law) return fmt::format("\nno calibrated law: {}\n", r.law_missing);
  const LawSummary& law = *r.law;
  std::string text = fmt::format(
      "\ncalibrated law, degree {}: {} coefficients from {} states at 15° to zigzag, bonds up to {:.2f} Å\n",
      law.degree, law.coefficient_eV_per_A2.size(), law.states_fitted, law.longest_bond_A);
  const auto line = [&](std::string_view name, const std::string& value) {
    text += fmt::format("  {:26}{}\n", name, value);
  };
  line("stress misfit", fmt::format("{:.2f} % rms, {:.2f} % at worst", 100 * law.rms_misfit, 100 * law.worst_misfit));
  line("anisotropy left out", fmt::format("up to {:.1f} % in stress along zigzag or armchair", 100 * law.anisotropy));
  line("longest bond", fmt::format("from the strain within {:.4f} Å", law.bond.worst_misfit_A));
  line(law.convex ? "convex in its range" : "NOT convex in its range",
       fmt::format("smallest stiffness {:.3f} eV/Å² at E1 = {:.3f}, E2 = {:.3f}", law.smallest_tangent_eV_per_A2,
                   law.smallest_tangent_at[0], law.smallest_tangent_at[1]));
  return text + form_lines(r.law_forms);
}

std::string csv(const Result& result) {
  std::string text = fmt::format(
      "# potential: {}\n# nominal stress (first Piola-Kirchhoff membrane force) over nominal strain, T = 0\n"
      "direction,strain,lateral_strain,stress_eV_per_A2,stress_N_per_m,longest_bond_A\n",
      result.potential.name);
  for (const StressCurve& c : result.stress_curves)
    for (std::size_t k = 0; k < c.strain.size(); ++k)
      text += fmt::format("{},{},{},{},{},{}\n", c.direction, c.strain[k], c.lateral_strain[k], c.stress_eV_per_A2[k],
                          c.stress_eV_per_A2[k] * N_per_m_per_eV_per_A2, c.longest_bond_A[k]);
  return text;
}

/// A strength that is the cut-off's is no value of its own: what is known is that carbon's is no less than what was
/// borne.
std::string strength(const StressCurve& c) {
  const double largest = c.strength_eV_per_A2 * N_per_m_per_eV_per_A2;
  if (!c.strength_is_artefact) return fmt::format("{:.1f}", largest);
  const double borne = c.largest_before_artefact_eV_per_A2.value_or(not_known) * N_per_m_per_eV_per_A2;
  return fmt::format("≥ {:.1f} (cut-off's: {:.1f})", borne, largest);
}

std::string curve_lines(const StressCurve& c) {
  const auto shown = [](double eV_per_A2) { return fmt::format("{:8.1f}", eV_per_A2 * N_per_m_per_eV_per_A2); };
  return fmt::format("{:12}{}{}{}   {:28}{:6.1f} %  {}\n", c.direction, shown(c.secant_2_eV_per_A2),
                     shown(c.secant_5_eV_per_A2), shown(c.secant_10_eV_per_A2), strength(c), 100 * c.strain_at_strength,
                     c.artefact_strain ? fmt::format("{:.1f} %", 100 * *c.artefact_strain) : std::string("not met"));
}

}  // namespace

std::string card_table(const Result& r) {
  const CardSummary& card = *r.card;
  std::string text = fmt::format("{}: {}\n  {}\n\n", r.potential.name, r.potential.description, r.potential.citation);
  const auto line = [&](std::string_view name, const std::string& value) {
    text += fmt::format("  {:26}{}\n", name, value);
  };
  const auto both = [](double x) { return fmt::format("{:9.2f} N/m  {:9.4f} eV/Å²", x * N_per_m_per_eV_per_A2, x); };
  line("lattice constant", fmt::format("{:.6f} Å", card.a0_A));
  line("energy per atom", fmt::format("{:.5f} eV", card.energy_per_atom_eV));
  line("C11", both(card.C11_eV_per_A2));
  line("C12", both(card.C12_eV_per_A2));
  line("C66 / ((C11−C12)/2) − 1", fmt::format("{:.2f} %", 100 * card.isotropy_error));
  line("sheet modulus E·h", both(card.Eh_eV_per_A2));
  line("Poisson's ratio", fmt::format("{:.4f}", card.nu));
  line("bending modulus", fmt::format("{:.4f} eV (zigzag)  {:.4f} eV (armchair)", card.bending_modulus_zigzag_eV,
                                      card.bending_modulus_armchair_eV));
  line("artefact from a bond of", fmt::format("{:.2f} Å", r.potential.artefact_bond_A));
  if (!r.potential.edit.empty()) line("edited", r.potential.edit);
  text +=
      "\n            secant modulus, N/m, at    strength, N/m               at strain  artefact from\n"
      "                 2 %     5 %    10 %\n";
  for (const auto& c : r.stress_curves) text += curve_lines(c);
  return text + law_lines(r) + warm_lines(r.warm, card.a0_A, card.Eh_eV_per_A2);
}

std::optional<std::string> write_card_files(const Result& result, const std::filesystem::path& folder) {
  write_file(folder / "card.json", json_text(result));
  write_run_h5(result, folder / "run.h5");
  write_file(folder / "stress-strain.csv", csv(result));
  if (result.law) write_file(folder / "law.toml", law_toml(result));
  return draw(stress_strain_plot(result), folder, "stress-strain");  // stress-strain.csv holds more than is drawn
}

}  // namespace validate
