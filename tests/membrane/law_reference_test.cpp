// The relaxed St Venant–Kirchhoff law against numbers of independent codes (compare/verify/README.md).
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "membrane/laws/prestress.hpp"
#include "membrane/laws/st_venant_kirchhoff.hpp"
#include "membrane/laws/tension_field.hpp"

namespace membrane {
namespace {

nlohmann::json read(const std::string& name) {
  std::ifstream file(std::string(LAW_CASES "/") + name);
  return nlohmann::json::parse(file);
}

void expect_case(const nlohmann::json& reference, const Voigt& prestress) {
  // Per volume: the thickness is 1 Å here.
  const StVenantKirchhoff law{reference.at("E"), reference.at("nu")};
  const auto Eg = reference.at("Eg").get<std::array<double, 3>>();
  const Voigt strain = Voigt(Eg[0], Eg[1], 2 * Eg[2]) + offset_strain(law, prestress);
  const Response at = tension_field(law, strain);
  const auto S = reference.at("S").get<std::array<double, 3>>();
  const auto D = reference.at("D_voigt").get<std::array<std::array<double, 3>, 3>>();
  const double tolerance = 1e-12 * law.sheet_modulus_eV_per_A2;  // 15 digits are given
  EXPECT_NEAR(at.energy_eV_per_A2, reference.at("W").get<double>(), tolerance);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(at.force_eV_per_A2[i], S[i], tolerance);
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(at.tangent_eV_per_A2(i, j), D[i][j], 10 * tolerance);
  }
  constexpr std::array names{"taut", "wrinkled", "slack"};
  EXPECT_EQ(names[static_cast<int>(sheet_state(law, principal_strains(strain)))], reference.at("state"));
}

TEST(LawReference, IsotropicPrestress) {
  const auto cases = read("law_cases.json");
  ASSERT_FALSE(cases.empty());
  for (const auto& reference : cases) {
    SCOPED_TRACE(reference.at("tag").get<std::string>());
    const double s0 = reference.at("s0");
    expect_case(reference, Voigt(s0, s0, 0));

    // Natural width, Eq. 7: the stretch across at which the stress across vanishes.
    const StVenantKirchhoff law{reference.at("E"), reference.at("nu")};
    const double offset = offset_strain(law, Voigt(s0, s0, 0))[0];
    const double lambda1 = reference.at("lam1");
    const double width = law.natural_width(0.5 * (lambda1 * lambda1 - 1) + offset) - offset;
    EXPECT_NEAR(std::sqrt(1 + 2 * width), reference.at("f_lam1").get<double>(), 1e-13);
  }
}

TEST(LawReference, GeneralPrestress) {
  const auto cases = read("law_cases_general.json");
  ASSERT_FALSE(cases.empty());
  for (std::size_t i = 0; i < cases.size(); ++i) {
    SCOPED_TRACE("case " + std::to_string(i));
    const auto sp = cases[i].at("sp").get<std::array<double, 3>>();
    expect_case(cases[i], Voigt(sp[0], sp[1], sp[2]));
  }
}

}  // namespace
}  // namespace membrane
