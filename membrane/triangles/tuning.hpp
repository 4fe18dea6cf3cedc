// What the solver on triangles is tuned by. None of it changes what an equilibrium is, only how it is found, unless a
// line says so. Where a line counts factorisations it compares them with those that the value here takes: a disc of 110
// Å and 40 rings in six depths to 24 Å takes 12, under a sphere of 20 Å 106, a pressurised square of 40 × 40 cells 497
// (its many states make that number itself uncertain by a factor of two).
#pragma once

#include <array>
#include <cstddef>

namespace membrane {

/// Newton's method (newton.cpp).
struct NewtonTuning {
  /// Of the triangles' forces on the nodes: no residual gets below it. Ten times less or more changes none of the paths
  /// above: it is for depths below 1e-4 of the radius, where all forces are differences of larger ones.
  static constexpr double rounding = 3e-14;
  /// Energies do not tell better from worse below a share of themselves, and of what they are counted from. 1e-10 does
  /// as well; 1e-14 takes the square 505 factorisations and 15 steps more.
  static constexpr double energy_noise = 1e-12, energy_rounding = 1e-15;
  /// Shares of the known negative curvature that are left out in turn, before all of it: the less, the faster the last
  /// steps converge.
  static constexpr std::array<double, 3> softened = {0.03, 0.1, 0.3};
  /// Of the tangent's largest diagonal entry, the first damping and its growth where the factor still fails. From 1e-5
  /// on the square takes 2788 factorisations and a cut: damping is felt where none is needed. 1e-9 does as well.
  static constexpr double least_damping = 1e-7, damping_growth = 10;
  /// A step shorter than this has the next ones damped, by so much more; whole steps undo it at the same pace. With a
  /// pace of 2 the square takes 547, with 10 505. Zones free to slide want it: see Newton::adapt_damping.
  static constexpr double short_step = 0.3, damping_pace = 4;
  /// No lower energy with a fresh factor: damping grows by this, up to the most that is worth a try.
  static constexpr double stuck_growth = 100, most_damping = 0.1;
};

/// The Cholesky factor (factor.cpp).
struct FactorTuning {
  /// Of the largest diagonal entry, the shift that tells a singular matrix from an indefinite one: far above rounding,
  /// far below the stiffness of any taut triangle.
  static constexpr double smallest_shift = 1e-10;
  /// Operations a factorisation does in the time of one entry's share in a solution: four an entry, twelve times
  /// faster.
  static constexpr double operations_per_entry = 48;
  /// Chord steps that may stand for a factorisation. Without the least of them a disc takes 14 factorisations; with
  /// eight a sphere takes 134 and twice the steps.
  static constexpr int fewest_steps = 3, most_steps = 12;
};

/// The softest direction of a sheet that bends, and the way off a saddle (softest.cpp, load_path.cpp).
struct SoftestTuning {
  /// Of the tangent's largest diagonal entry: shifts that are tried in turn.
  static constexpr double first_shift = 1e-9, shift_growth = 4, most_shift = 0.1;
  /// Solutions of the inverse iteration. A disc of 32 rings at twice the depth where it wrinkles: 15 leave the sign
  /// right and the stiffness off by a tenth, 40 by 1e-3.
  static constexpr int iterations = 40;
  /// Of the length over which the sheet bends, √(κ/E·h): the first step off a saddle.
  static constexpr double first_step = 0.01;
  /// Saddles left at one level; after the second there was never another.
  static constexpr int most_saddles = 6;
};

/// Contact (model.cpp, load_path.cpp).
struct ContactTuning {
  /// Stiffness over the sheet modulus: above that of the sheet's elements, so that few updates of the multipliers
  /// settle a contact, and not so far that it spoils the tangent's condition. 100 takes a sphere 231 factorisations,
  /// 1000 384; 1 takes 53, but leaves the force 1e-8 less exact (the multipliers stop further from their end).
  static constexpr double stiffness = 10;
  /// Contact radius over the sphere's at strong indentation: inside, rings are equally wide. It moves nodes: a quarter
  /// instead of a half changes the force by 3e-4, 0.9 by 5e-4, the mesh's own error.
  static constexpr double likely_radius = 0.5;
  /// Updates of the contact forces at one value: five are enough for the paths above.
  static constexpr int most_rounds = 40;
};

/// The first guess (start.cpp, drive.cpp).
struct StartTuning {
  /// Artificial pretension over the sheet modulus. Only the shape is used: 1e-4 and 1 lead to the same iterations.
  static constexpr double stiffening = 0.01;
  /// Of the sheet's size, a motion so small that its forces are linear and so large that they do not drown in rounding.
  static constexpr double small_motion = 1e-7;
  /// Of the first amplitude's bracket, which spans a factor of two: four and thirty lead to the same iterations.
  static constexpr int bisections = 12;
  /// Cells along an edge of the coarsest rectangle that a path begins on: enough for the tucks of a bulge; a plane
  /// sheet has none. The square begun on its own 40 cells finds a state 0.26 eV higher (59.25 for 59.29 Å).
  static constexpr int cells_for_tucks = 20, cells_in_plane = 5;
};

/// Guesses along a path (predictor.cpp, load_path.cpp).
struct PathTuning {
  /// One point takes a disc 25 steps, two 21, four 18, six 19. (A sphere is cheapest with one, 53 factorisations:
  /// where contact ends, the sheet is no polynomial in the depth.)
  static constexpr std::size_t most_points = 4;
  /// Steps ahead over the span of the points that are extrapolated from; the hundredth is for rounding. Three changes
  /// nothing in steps of one length; half of it costs two steps of twenty by force.
  static constexpr double farthest = 1.01;
  /// Slopes of log d over log F: a force that stretches has 1/3, one that only tilts 1; a shifted factor may say
  /// anything else.
  static constexpr double least_slope = 0.2, most_slope = 1.2;
  /// What a parabola may bend of the slope: it is a local guess.
  static constexpr double most_bend = 0.5;
  /// Failed attempts on the way to one level. None of the paths above has one.
  static constexpr int most_cuts = 12;
};

}  // namespace membrane
