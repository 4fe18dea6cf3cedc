// The misprinted equations of Gil, Adhikari, Scarpa & Bonet, J. Phys.: Condens. Matter 22 (2010) 145302.
#pragma once

#include "compare/verify/ledger.hpp"

namespace validate::verify {

/// Eqs. 2, 4, 12, 13, and 15, which needs 12: the corrected form is what the law computes, the printed one is
/// not.
void verify_misprints(Ledger& ledger);

}  // namespace validate::verify
