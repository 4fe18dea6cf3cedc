// The deepest sheet seen from above: the atoms' longest bonds and the membrane's stress, side by side.
#pragma once

#include <string>
#include <vector>

#include "compare/documents/bytes/extxyz.hpp"
#include "compare/documents/plots/plot.hpp"
#include "compare/results/run.hpp"

namespace validate {

/// The free atoms under `load` coloured by their longest bond (Å), and the larger principal Cauchy force (N/m) of the
/// membrane's triangles at its last depth. What is not there has no panel. Under a point load the force at the centre
/// has no bound: the map begins a hundredth of the radius away.
Plot from_above_plot(LoadKind load, const std::vector<AtomFromAbove>& atoms, const Run* membrane);

}  // namespace validate
