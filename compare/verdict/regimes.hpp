// What parts the atoms from a plain membrane, depth by depth, in one word.
#pragma once

#include "compare/results/verdict.hpp"

namespace validate {

/// By the largest of what a plain membrane lacks at each of these depths, where it is beyond the tolerance: bending, or
/// the law's softening or hardening; cancellation where one takes away at least half of the other and what is left is
/// within the tolerance. Without an explanation (or at a depth that it leaves out) by the force ratio: above 1 +
/// tolerance bending, below 1 − tolerance softening.
std::vector<Regime> regimes_of(const Comparison& comparison, const std::vector<bool>& artefact,
                               const Explanation* explanation, double tolerance);

}  // namespace validate
