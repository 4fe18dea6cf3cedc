// What a potential's card and law, and a sheet of atoms, are in a result.
#pragma once

#include "compare/pairing/sheet.hpp"
#include "compare/potential/potential_card.hpp"
#include "compare/results/result.hpp"

namespace validate {

/// Card and law, or why there is none, as every experiment has them.
void summarise(const PotentialCard& card, Result& result);

/// And all that `validate potential` tells: description, stress under large strain, the states behind the law.
Result potential_result(const PotentialCard& card);

SheetSummary summary_of(const Case& c, const PairedSheet& sheet);

}  // namespace validate
