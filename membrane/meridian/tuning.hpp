// What the solver on a meridian is tuned by. None of it changes what an equilibrium is, only how it is found, unless a
// line says so.
#pragma once

namespace membrane::meridian {

/// Newton's method (newton.cpp).
struct NewtonTuning {
  /// Of √(rᵀ K⁻¹ r / energy): what is aimed at, and what is good enough where rounding stops the fall.
  static constexpr double aim = 1e-11, tolerance = 1e-9;
  /// Steps that leave more than this share of the residual are stalls; so many in a row are rounding.
  static constexpr double stall = 0.3;
  static constexpr int most_stalls = 2;
  static constexpr int most_searches = 200;
  /// Of what the energy is the sum of.
  static constexpr double energy_noise = 1e-13;
  /// Of the diagonal: added where the Hessian is not positive definite, and its growth.
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
  /// Of the last step, how far a sheet that started flat is extrapolated.
  static constexpr double farthest = 2;
};

/// The barrier of a sphere (path.cpp, assembly.cpp).
struct ContactTuning {
  /// Of the energy over the sphere's area, and its share left at each stride; later strides are longer.
  static constexpr double first_barrier = 1e-3, barrier_decay = 0.1;
  /// The barrier falls until the gap that bears the force is this share of the depth, or close to it. It is the error
  /// in depth.
  static constexpr double last_slack = 1e-8, close_enough = 0.98;
  /// Of the energy, a barrier under which the sheet is clear of the sphere.
  static constexpr double no_contact = 1e-14;
  /// Of the sphere's radius, where contact is watched: no sheet is drawn in so far.
  static constexpr double watched_share = 2;
  /// Of a gap or pressure, what a step may take.
  static constexpr double boundary_share = 0.99;
  /// From what the barrier has across a gap, how far its pressure may be.
  static constexpr double farthest_pressure = 1e4;
};

/// The elements' lengths (mesh.cpp): they set the accuracy (README).
struct MeshTuning {
  /// Of an element over the shortest one, per distance from it.
  static constexpr double growth = 0.3;
  static constexpr double largest_share = 1.0 / 40;  ///< of the radius
  static constexpr double under_load = 1.0 / 10;     ///< of the load's radius
  static constexpr double under_sphere = 1.0 / 60;   ///< of the sphere's radius: contact ends somewhere inside
  static constexpr double first_contact = 1.0 / 8;  ///< of that, at the tip, where contact begins if nothing spreads it
  static constexpr double layer_share = 3;          ///< of √(κ/E·h), the thinnest boundary layer there can be
  static constexpr double point_membrane = 1e-10;   ///< of the radius: w ~ r^(2/3), no length of its own
  static constexpr double point_plate = 1e-4;       ///< of the radius: w ~ r² ln r
};

}  // namespace membrane::meridian
