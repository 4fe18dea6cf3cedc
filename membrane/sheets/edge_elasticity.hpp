// What the free edge of a sheet has of its own.
#pragma once

namespace membrane {

/// Energy τ e + ½ K e² per reference length, e the stretch less one. τ < 0: the edge would be longer, and pushes a
/// round rim outwards.
struct EdgeElasticity {
  double stress_eV_per_A = 0;     ///< τ
  double stiffness_eV_per_A = 0;  ///< K, what the edge has more (or less) than the sheet that ends there
};

}  // namespace membrane
