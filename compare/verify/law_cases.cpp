#include "compare/verify/law_cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "law_cases_json.hpp"
#include "membrane/laws/prestress.hpp"
#include "membrane/laws/st_venant_kirchhoff.hpp"
#include "membrane/laws/tension_field.hpp"

namespace validate::verify {
namespace {

using namespace membrane;
using nlohmann::json;

/// Largest differences from the reference over the cases, by E; per volume, the thickness being 1 Å.
struct Differences {
  double energy = 0, force = 0, tangent = 0;
  int states = 0;  ///< that are others

  void add(const json& reference, const Voigt& prestress) {
    const StVenantKirchhoff law{reference.at("E"), reference.at("nu")};
    const double E = law.sheet_modulus_eV_per_A2;
    const auto strain = reference.at("Eg").get<std::array<double, 3>>();
    const auto S = reference.at("S").get<std::array<double, 3>>();
    const auto D = reference.at("D_voigt").get<std::array<std::array<double, 3>, 3>>();
    const Voigt offset = Voigt(strain[0], strain[1], 2 * strain[2]) + offset_strain(law, prestress);
    const Response at = tension_field(law, offset);
    energy = std::max(energy, std::abs(at.energy_eV_per_A2 - reference.at("W").get<double>()) / E);
    for (int i = 0; i < 3; ++i) {
      force = std::max(force, std::abs(at.force_eV_per_A2[i] - S[i]) / E);
      for (int j = 0; j < 3; ++j) tangent = std::max(tangent, std::abs(at.tangent_eV_per_A2(i, j) - D[i][j]) / E);
    }
    constexpr std::array names{"taut", "wrinkled", "slack"};
    if (names[static_cast<int>(sheet_state(law, principal_strains(offset)))] != reference.at("state")) ++states;
  }
};

template <class PrestressOf>
void verify_cases(Ledger& ledger, const std::string& name, const char* text, PrestressOf prestress_of) {
  const json cases = json::parse(text);
  Differences differences;
  for (const json& reference : cases) differences.add(reference, prestress_of(reference));
  const Reference none = separate_code(0, name + ", 15 digits");
  const std::string note = fmt::format("largest over {} states, taut, wrinkled and slack", cases.size());
  ledger.begin("relaxed St Venant-Kirchhoff, " + name);
  ledger.equal("|psi - reference|/E", differences.energy, none, 1e-12, note);
  ledger.equal("|S - reference|/E", differences.force, none, 1e-12, note);
  ledger.equal("|dS/dE - reference|/E", differences.tangent, none, 1e-11, note);
  ledger.equal("other states", differences.states, none, 0, note);
}

}  // namespace

void verify_law_cases(Ledger& ledger) {
  verify_cases(ledger, "isotropic prestress", law_cases_json, [](const json& c) {
    const double s0 = c.at("s0");
    return Voigt(s0, s0, 0);
  });
  verify_cases(ledger, "any prestress", law_cases_general_json, [](const json& c) {
    const auto s = c.at("sp").get<std::array<double, 3>>();
    return Voigt(s[0], s[1], s[2]);
  });
}

}  // namespace validate::verify
