// At which depths, forces or pressures each curve of a study is computed.
#pragma once

#include <vector>

#include "compare/pairing/pairing.hpp"

namespace validate {

/// Gives every curve of a paired load its levels: the case's own, and for the atoms of the judged load those that its
/// verdict needs, found by the continuum that they are judged against. Continua that stand beside atoms reach a little
/// further on both sides, and the cheap ones are computed in between, too. Where there is a calibrated sheet, the atoms
/// get its shapes to start from.
void set_levels(const Case& c, PairedLoad& load);

/// The continuum's problem with these levels.
void set_levels(ContinuumExperiment& experiment, const std::vector<double>& levels);

}  // namespace validate
