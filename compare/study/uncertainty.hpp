// How far the judged ratios are uncertain: what their continuum would say with each of its inputs another.
#pragma once

#include "compare/pairing/pairing.hpp"
#include "compare/results/result.hpp"

namespace validate {

/// Sets the uncertainties of the result's judged ratios and settles the outcome again. The continuum is solved on its
/// meridian once as it is and once each with finer elements (beside the curve that was judged), the clamp radius, the
/// slope margin, the tip and κ larger by their standard errors (sheet's, card's); the card's constants and the law's
/// misfit are in proportion to the force. A sheet that has no meridian takes its clamp's error as that of a membrane, F
/// ∝ 1/a².
void add_uncertainties(Result& result, const PairedLoad& load);

}  // namespace validate
