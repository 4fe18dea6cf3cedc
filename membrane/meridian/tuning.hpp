// What the solver on a meridian is tuned by. None of it changes what an equilibrium is, only how it is found, unless a
// line says so. Where a line counts factorisations it compares them with those that the value here takes: a disc of 110
// Å in six depths to 24 Å takes 22 under a patch of 11 Å, 237 under a sphere of 20 Å, 185 under one of 2 Å, and 202
// with a law that softens (Lee et al.) under one of 5.5 Å.
#pragma once

namespace membrane::meridian {

/// Newton's method (newton.cpp).
struct NewtonTuning {
  /// Of √(rᵀ K⁻¹ r / energy): what is aimed at, and what is good enough where rounding stops the fall. An aim of 1e-13
  /// takes 27 and 264, and no force changes by 1e-8.
  static constexpr double aim = 1e-11, tolerance = 1e-9;
  /// Steps that leave more than this share of the residual are stalls; so many in a row are rounding. None happens
  /// above.
  static constexpr double stall = 0.3;
  static constexpr int most_stalls = 2;
  /// Steps of one search; the paths above take some 36 a level, all strides of the barrier together.
  static constexpr int most_searches = 200;
  /// Of what the energy is the sum of: with 1e-15 the law that softens takes 230, with 1e-11 nothing changes.
  static constexpr double energy_noise = 1e-13;
  /// Of the diagonal: added where the Hessian is not positive definite, and its growth. The paths above need none.
  /// To give up Lee et al.'s law with bending under a point, at 15.4 Å, takes 6955; from 1e-13 on 9240; by threes
  /// 12502.
  static constexpr double first_shift = 1e-10, shift_growth = 30, most_shift = 1e3;
};

/// The way along the levels (path.cpp, predictor.cpp).
struct PathTuning {
  /// Failed attempts on the way to one level, and the work on it: most take thirty factorisations, but the way out of
  /// the flat sheet can take thousands.
  static constexpr int most_cuts = 12, most_factorisations = 5000, most_for_the_first = 30000;
  /// Secants for a force, and how near they come to it.
  static constexpr int most_corrections = 40;
  static constexpr double force_tolerance = 1e-10;
  /// Of the depth: points nearer to each other have no secant.
  static constexpr double coincident = 1e-9;
  /// Of the last step, how far a sheet that started flat is extrapolated. In even steps 1 and 10 do the same.
  static constexpr double farthest = 2;
};

/// The barrier of a sphere (path.cpp, assembly.cpp).
struct ContactTuning {
  /// Of the energy over the sphere's area, and its share left at each stride; later strides are longer. Begun at 1e-5
  /// the spheres take 491 and 368; at 0.1 the law that softens is lost at 19.8 Å. A share of 0.01 or 0.3 changes
  /// at most 4 %.
  static constexpr double first_barrier = 1e-3, barrier_decay = 0.1;
  /// The barrier falls until the gap that bears the force is this share of the depth, or close to it. It is an error:
  /// 1e-5 (160 factorisations) changes the force by 2e-4, 1e-10 (276) by 3e-7.
  static constexpr double last_slack = 1e-8, close_enough = 0.98;
  /// Of the energy, a barrier under which the sheet is clear of the sphere.
  static constexpr double no_contact = 1e-14;
  /// Of the sphere's radius, where contact is watched: no sheet is drawn in so far.
  static constexpr double watched_share = 2;
  /// Of a gap or pressure, what a step may take: 0.9 takes 252, 0.999 230.
  static constexpr double boundary_share = 0.99;
  /// From what the barrier has across a gap, how far its pressure may be: 10 takes the small sphere 197.
  static constexpr double farthest_pressure = 1e4;
};

/// The elements' lengths (mesh.cpp): they set the accuracy, given here as what changes in force.
struct MeshTuning {
  /// Of an element over the shortest one, per distance from it: 0.1 changes a point's force by 2e-8, 1 by 3e-6.
  static constexpr double growth = 0.3;
  /// Of the radius: 1/100 changes a sheet that bends by 4e-7.
  static constexpr double largest_share = 1.0 / 40;
  /// Of the load's radius: 0.03 changes a disc by less than 1e-9, its depth of record by 3e-8, 0.3 that by 6e-7.
  static constexpr double under_load = 1.0 / 10;
  /// Of the sphere's radius: contact ends somewhere inside. 1/200 changes 5e-6, 1/20 8e-5.
  static constexpr double under_sphere = 1.0 / 60;
  /// Of that, at the tip, where contact begins if nothing spreads it.
  static constexpr double first_contact = 1.0 / 8;
  /// Of √(κ/E·h), the thinnest boundary layer there can be: 1 changes 1.3e-6, 10 3e-5.
  static constexpr double layer_share = 3;
  /// Of the radius, under a point: a membrane's w ~ r^(2/3) has no length of its own (1e-6 changes 1.4e-5), a plate's
  /// is r² ln r.
  static constexpr double point_membrane = 1e-10, point_plate = 1e-4;
};

}  // namespace membrane::meridian
