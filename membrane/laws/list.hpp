// Every material law. A new one is two files beside this one and a name here; the tests run over this list.
#pragma once

#include <variant>

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

}  // namespace membrane
