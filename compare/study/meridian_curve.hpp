// A continuum's curve in one dimension, and how it ends: where the law's calibration does, or where the sheet tears.
#pragma once

#include "compare/pairing/pairing.hpp"

namespace validate {

/// Follows the levels up to the first that is not reached or an interrupt. A curve of a law that knows its longest bond
/// also ends
///   calibration_end  where that bond, or the last one that was found, is beyond what the law is calibrated to: what
///                    follows is the fit's;
///   rupture          where no equilibrium lies beyond, within the calibration, and a stiffness of the law is lost: the
///                    sheet's own end, found to a sixteenth of a step between levels if `to_the_end`.
void solve_on_meridian(ContinuumExperiment& experiment, bool to_the_end = true);

}  // namespace validate
