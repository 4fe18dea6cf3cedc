// A bulge's atoms beside its membrane.
#pragma once

#include "compare/documents/plots/plot.hpp"
#include "compare/study/bulge_atoms.hpp"

namespace validate {

/// Depth of the centre against pressure where there is more than one pressure, both logarithmic (a membrane's is a line
/// of slope 1/3), and both cross-sections at the last. No panel without a cross-section of both.
Plot bulge_atoms_plot(const BulgeAtoms& atoms);

}  // namespace validate
