// The verdict: do the atoms and the like-for-like membrane agree?
#pragma once

#include "compare/result.hpp"

namespace compare {

/// Compares the atomistic run of the judged load with the membrane run of the same load and the card's
/// constants.
///
/// The window [lo, hi] is in depth/a, a the atoms' effective radius. Judged are the atoms' usable points
/// inside it and the two that bracket it: the last at or below lo and the first at or above hi. At each of
/// these depths of record the membrane's force is interpolated (Curve) and |F_atoms / F_continuum − 1| taken;
/// the largest must not exceed the tolerance. Sets `agreement`, or `agreement_skipped` with the reason when a
/// curve is missing or does not cover the window.
void judge(Result& result);

/// Sets `comparisons`: for each load with an atomistic and a like-for-like membrane run, the ratios at every converged
/// depth of the atoms that the membrane's curve covers, and the regimes by the case's tolerance: bending (ratio above
/// 1 + tolerance, before any smaller one), softening (below 1 − tolerance), artefact (longest bond), membrane between.
void compare_curves(Result& result);

}  // namespace compare
