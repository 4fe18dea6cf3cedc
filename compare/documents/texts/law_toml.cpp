#include "compare/documents/texts/law_toml.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace validate {
namespace {

/// A TOML basic string: JSON's escapes are TOML's.
std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string rows(const std::vector<int>& a, const std::vector<int>& b, const std::vector<double>& c) {
  std::string text;
  for (std::size_t k = 0; k < c.size(); ++k) text += fmt::format("  [{}, {}, {}],\n", a[k], b[k], c[k]);
  return text;
}

}  // namespace

std::string law_toml(const Result& result) {
  const LawSummary& law = *result.law;
  const CardSummary& card = *result.card;
  const PotentialSummary& potential = result.potential;
  return fmt::format(
      "# Graphene as the potential {name} has it: a hyperelastic sheet at T = 0.\n"
      "#\n"
      "# Energy per reference area, E the Green-Lagrange strain, I = tr E, q^2 = (dev E : dev E)/2 (q = |E1 - E2|/2):\n"
      "#   W = (C11 + C12)/4 I^2 + (C11 - C12) q^2 + sum of c I^a q^b,\n"
      "# second Piola-Kirchhoff membrane force S = W_I 1 + W_q/(2 q) dev E; bending 1/2 kappa (k1 + k2)^2 per "
      "reference "
      "area.\n"
      "# Do not relax the law (tension field) where the sheet bends: bending is what limits compression.\n\n"
      "potential = {potential}\ncitation = {citation}\nsha256 = {sha}\nlammps = {lammps}\n\n"
      "lattice_constant_A = {a0}\nC11_eV_per_A2 = {C11}\nC12_eV_per_A2 = {C12}\nbending_modulus_eV = {kappa}\n\n"
      "degree = {degree}\nterms_eV_per_A2 = [  # a, b, c\n{terms}]\nrms_misfit = {rms}\nworst_misfit = {worst}\n\n"
      "# The law holds for principal strains from smallest_strain up to where the longest bond,\n"
      "#   l = rest_A + sum of c I^a q^b, reaches its longest_A.\n"
      "[range]\nsmallest_strain = {smallest}\nlongest_A = {longest}\nconvex = {convex}\n\n"
      "[longest_bond]\nrest_A = {rest}\nterms_A = [  # a, b, c\n{bond_terms}]\nworst_misfit_A = {bond_worst}\n",
      fmt::arg("name", potential.name), fmt::arg("potential", quoted(potential.name)),
      fmt::arg("citation", quoted(potential.citation)), fmt::arg("sha", quoted(potential.sha256)),
      fmt::arg("lammps", quoted(card.lammps)), fmt::arg("a0", card.a0_A), fmt::arg("C11", card.C11_eV_per_A2),
      fmt::arg("C12", card.C12_eV_per_A2), fmt::arg("kappa", card.bending_modulus_eV), fmt::arg("degree", law.degree),
      fmt::arg("terms", rows(law.power_of_I, law.power_of_q, law.coefficient_eV_per_A2)),
      fmt::arg("rms", law.rms_misfit), fmt::arg("worst", law.worst_misfit), fmt::arg("smallest", law.smallest_strain),
      fmt::arg("longest", law.longest_bond_A), fmt::arg("convex", law.convex), fmt::arg("rest", law.bond.rest_A),
      fmt::arg("bond_terms", rows(law.bond.power_of_I, law.bond.power_of_q, law.bond.coefficient_A)),
      fmt::arg("bond_worst", law.bond.worst_misfit_A));
}

}  // namespace validate
