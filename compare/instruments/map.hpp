// Curves that lie on a grid of places, each of which knows only its own.
#pragma once

#include <vector>

#include "compare/results/recording.hpp"

namespace validate {

/// Numbers curves of several files by their order, where they have no numbers that differ; sets shape, centre, outer
/// size and indices of the grid where their places make one.
void number_as_map(std::vector<Recording>& recordings);

}  // namespace validate
