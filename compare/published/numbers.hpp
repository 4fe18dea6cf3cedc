// Our side of a published number, computed when asked for.
#pragma once

#include "compare/potential/potential_card.hpp"
#include "compare/published/entry.hpp"

namespace validate::published {

/// Of a potential's card and response, in the subject's base unit. Throws std::logic_error for another owner's.
double number_of(const PotentialCard& card, Subject subject);

/// Of the membrane in one dimension, St Venant–Kirchhoff. Throws Error (not converged).
double number_of_membrane(const Entry& entry);

}  // namespace validate::published
