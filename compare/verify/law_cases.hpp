// The relaxed law of Gil et al. 2010 against states computed with codes written separately.
#pragma once

#include "compare/verify/ledger.hpp"

namespace validate::verify {

/// Energy, force, tangent and state of law_cases.json and law_cases_general.json.
void verify_law_cases(Ledger& ledger);

}  // namespace validate::verify
