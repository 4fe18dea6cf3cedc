// The verdict: do the atoms and the like-for-like membrane agree?
#pragma once

#include <optional>

#include "compare/results/result.hpp"

namespace validate {

/// Depth (Å) at which a run's longest bond reaches a length, between the converged points around it; nothing where it
/// does not, or has none.
std::optional<double> depth_at_bond(const Run& run, double bond_A);

/// Holds the atomistic run of the judged load against the continuum that the case names: the calibrated sheet, or the
/// membrane with the card's constants, under the same load.
///
/// The window [lo, hi] is in depth/a, a the atoms' effective radius. It is cut off where the atoms' longest bond
/// reaches the case's length and where a path that reached its largest depth ends. Judged are the atoms' usable points
/// inside it and those that bracket it: the last at or below lo and the first at or above hi, if its bonds are not too
/// long. At each of these depths of record the continuum's force is interpolated (Curve) and |F_atoms / F_continuum −
/// 1| taken; the outcome is that of exact ratios, until uncertainties are there (settle). Sets `agreement`, or
/// `agreement_skipped` with the reason when a curve is missing or does not cover the window.
void judge(Result& result);

/// Settles the outcome from the ratios, their uncertainties and the tolerance (the idea of ASME V&V 20): with E the
/// difference and U its expanded uncertainty, agreement if |E| + U <= tolerance at every depth judged, disagreement if
/// |E| − U > tolerance at some, else undecided. Sets what is largest, too.
void settle(Agreement& agreement);

/// Sets `comparisons`: for each load with an atomistic and a like-for-like membrane run, the ratios at every converged
/// depth of the atoms that the membrane's curve covers, and the regimes by the case's regime tolerance.
void compare_curves(Result& result);

}  // namespace validate
