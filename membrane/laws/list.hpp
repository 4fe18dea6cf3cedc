// Every material law. A new one is two files beside this one and a name in Law: its forms() make it known by name, its
// examples() have it tried by the tests and by verification, and without either it does not compile.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "membrane/laws/cauchy_born.hpp"
#include "membrane/laws/cauchy_born_sixfold.hpp"
#include "membrane/laws/cauchy_born_table.hpp"
#include "membrane/laws/lee_graphene.hpp"
#include "membrane/laws/mooney_rivlin.hpp"
#include "membrane/laws/st_venant_kirchhoff.hpp"

namespace membrane {

/// Neo-Hookean is Mooney–Rivlin without its second term: neo_hookean() makes it.
using Law = std::variant<StVenantKirchhoff, MooneyRivlin, LeeGraphene, CauchyBorn, CauchyBornTable, CauchyBornSixfold>;

/// Whether a law is the same from every direction.
bool is_isotropic(const Law& law);

/// E·h of small strains.
double sheet_modulus(const Law& law);

/// A compressive membrane force (eV/Å²) that is no more than rounding.
inline double least_compression(const Law& law) { return 1e-9 * sheet_modulus(law); }

/// Poisson ratio of small strains.
double poisson_ratio(const Law& law);

/// A law that can be made by name.
struct LawEntry {
  std::string_view name, meaning;
  std::vector<LawParameter> parameters;
};

/// In the order of Law. Laws whose parameters are data are not among them.
std::vector<LawEntry> laws_by_name();

/// The law of a name with its parameters (E·h in eV/Å²). Throws std::invalid_argument for a name or parameter that
/// there is not (naming those there are), for one that is missing, and for values that the law refuses.
Law make_law(std::string_view name, const LawValues& values);

struct NamedLaw {
  std::string name;
  Law law;
};

/// Every law at its examples: what the tests and verification run over.
std::vector<NamedLaw> example_laws();

/// The same sheet, turned in its plane by an angle (radians) together with its lattice.
template <IsotropicLaw L>
L turned(const L& law, double) {
  return law;
}
inline CauchyBornSixfold turned(CauchyBornSixfold law, double angle_rad) {
  law.zigzag_rad += angle_rad;
  return law;
}

}  // namespace membrane
