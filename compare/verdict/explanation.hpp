// What the plain membrane lacks to be the atoms, piece by piece.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "compare/results/result.hpp"

namespace validate {

/// The continua between the plain membrane and the atoms, each with one piece of physics more than the one before:
/// nominal radii, paired radii, bending, the potential's own law.
using Stages = std::array<const Run*, 4>;

/// Force of a sheet with the lattice's directions over that of one without, against the controlled depth.
struct Anisotropy {
  std::vector<double> conjugate_depth_A, ratio;

  /// Interpolated, the end's value beyond; NaN where nothing is known.
  double at(double conjugate_depth_A) const;
};

/// At every converged depth of the atoms outside the artefact zone that all stages cover; nothing where there is none.
std::optional<Explanation> explain(const Run& atoms, const Stages& stages, const Anisotropy& anisotropy);

}  // namespace validate
