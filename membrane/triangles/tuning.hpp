// What the solver on triangles is tuned by. None of it changes what an equilibrium is, only how it is found, unless a
// line says so.
#pragma once

#include <array>
#include <cstddef>

namespace membrane {

/// Newton's method (newton.cpp).
struct NewtonTuning {
  /// Of the triangles' forces on the nodes: no residual gets below it.
  static constexpr double rounding = 3e-14;
  /// Energies do not tell better from worse below a share of themselves, and of what they are counted from.
  static constexpr double energy_noise = 1e-12, energy_rounding = 1e-15;
  /// Shares of the known negative curvature that are left out in turn, before all of it.
  static constexpr std::array<double, 3> softened = {0.03, 0.1, 0.3};
  /// Of the tangent's largest diagonal entry, the first damping and its growth where the factor still fails.
  static constexpr double least_damping = 1e-7, damping_growth = 10;
  /// A step shorter than this has the next ones damped, by so much more; whole steps undo it at the same pace.
  static constexpr double short_step = 0.3, damping_pace = 4;
  /// No lower energy with a fresh factor: damping grows by this, up to the most that is worth a try.
  static constexpr double stuck_growth = 100, most_damping = 0.1;
};

/// The Cholesky factor (factor.cpp).
struct FactorTuning {
  /// Of the largest diagonal entry, the shift that tells a singular matrix from an indefinite one.
  static constexpr double smallest_shift = 1e-10;
  /// Operations a factorisation does in the time of one entry's share in a solution.
  static constexpr double operations_per_entry = 48;
  /// Chord steps that may stand for a factorisation.
  static constexpr int fewest_steps = 3, most_steps = 12;
};

/// Contact (model.cpp, load_path.cpp).
struct ContactTuning {
  /// Stiffness over the sheet modulus: above that of the sheet's elements, so that few updates of the multipliers
  /// settle a contact, and not so far that it spoils the tangent's condition.
  static constexpr double stiffness = 10;
  /// Contact radius over the sphere's at strong indentation: inside, rings are equally wide. It moves nodes.
  static constexpr double likely_radius = 0.5;
  /// Updates of the contact forces at one value.
  static constexpr int most_rounds = 40;
};

/// The first guess (start.cpp, drive.cpp).
struct StartTuning {
  /// Artificial pretension over the sheet modulus. Only the shape is used: any tension gives the same one.
  static constexpr double stiffening = 0.01;
  /// Of the sheet's size, a motion so small that its forces are linear.
  static constexpr double small_motion = 1e-7;
  /// Of the first amplitude's bracket, which spans a factor of two: 1/4096 of it is left.
  static constexpr int bisections = 12;
  /// Cells along an edge of the coarsest rectangle that a path begins on: enough for the tucks of a bulge; a plane
  /// sheet has none.
  static constexpr int cells_for_tucks = 20, cells_in_plane = 5;
};

/// Guesses along a path (predictor.cpp, load_path.cpp).
struct PathTuning {
  /// A higher polynomial gains nothing over steps of ordinary length.
  static constexpr std::size_t most_points = 4;
  /// Steps ahead over the span of the points that are extrapolated from; the hundredth is for rounding.
  static constexpr double farthest = 1.01;
  /// Slopes of log d over log F: a force that stretches has 1/3, one that only tilts 1; a shifted factor may say
  /// anything else.
  static constexpr double least_slope = 0.2, most_slope = 1.2;
  /// What a parabola may bend of the slope: it is a local guess.
  static constexpr double most_bend = 0.5;
  /// Failed attempts on the way to one level.
  static constexpr int most_cuts = 12;
};

}  // namespace membrane
