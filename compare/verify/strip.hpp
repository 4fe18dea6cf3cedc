// The stretched strip in bending.
#pragma once

#include "compare/verify/ledger.hpp"

namespace validate::verify {

/// M. Stein & J. M. Hedgepeth, NASA TN D-813 (1961): a band of the strip's width that bears nothing.
void verify_bent_strip(Ledger& ledger);

}  // namespace validate::verify
