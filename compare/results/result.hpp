// What a run of the comparison produced. Base units Å, eV; the N/m twins are made where a document is
// written. A number that is not known stays NaN and becomes null (JSON) or an empty cell (CSV), never 0.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compare/input/case.hpp"

namespace validate {

struct SheetPicture;

enum class Model { membrane, atomistic, sheet };                ///< sheet: a membrane that resists bending
enum class Constants { card, paper, given, calibrated, none };  ///< none: atomistic
enum class Ended { depth_max, artefact, rupture, not_converged };

inline constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

std::string_view to_string(Model);
std::string_view to_string(Constants);
std::string_view to_string(Ended);

/// Also for a curve whose program failed: "failed".
std::string_view to_string(const std::optional<Ended>&);

/// What Eq. 16 reads from a membrane whose E·h and pretension are known, at the depths of the fit, and what
/// follows for the curve fitted: E·h by the ratio, the pretension by the difference.
struct FitBias {
  double Eh_true_eV_per_A2 = 0, Eh_read_eV_per_A2 = 0;
  double pretension_true_eV_per_A2 = 0, pretension_read_eV_per_A2 = 0;
  double Eh_corrected_eV_per_A2 = 0, pretension_corrected_eV_per_A2 = 0;
};

/// The membrane model itself, with the real tip, fitted to the curve.
struct DirectFit {
  double Eh_eV_per_A2 = 0, Eh_stderr_eV_per_A2 = 0;
  double pretension_eV_per_A2 = 0, pretension_stderr_eV_per_A2 = 0;
  double rms_relative = 0;
};

/// Eq. 16, or another closed form, fitted to a curve.
struct Fit {
  double Eh_eV_per_A2 = 0, Eh_stderr_eV_per_A2 = 0;
  double pretension_eV_per_A2 = 0, pretension_stderr_eV_per_A2 = 0;
  double correlation = 0;                  ///< of the two parameters
  std::vector<double> correlation_matrix;  ///< of all parameters, row by row: E·h, pretension, then the offsets
  double rms_relative = 0;                 ///< root mean square residual over the largest force
  std::array<double, 2> window_A{};
  int points = 0;

  double r_squared = not_known, condition_number = not_known;
  std::array<double, 2> Eh_interval_eV_per_A2{not_known, not_known};          ///< 95 %, profile likelihood
  std::array<double, 2> pretension_interval_eV_per_A2{not_known, not_known};  ///< 95 %, profile likelihood
  double Eh_bootstrap_eV_per_A2 = not_known;                    ///< standard error from refits to drawn residuals
  double pretension_bootstrap_eV_per_A2 = not_known;            ///< the same
  std::vector<double> fitted_depth_A, residual_eV_per_A;        ///< the points fitted, force − model
  std::optional<double> depth_offset_A, force_offset_eV_per_A;  ///< where asked for
  std::optional<double> depth_offset_stderr_A, force_offset_stderr_eV_per_A;

  std::optional<FitBias> bias;
  std::optional<DirectFit> direct;
  std::vector<std::string> warnings;  ///< what a careful reader would say of this fit
};

/// The fit against the depth up to which points are used.
struct WindowScan {
  std::vector<double> depth_max_A, Eh_eV_per_A2, pretension_eV_per_A2;
};

/// What a four times stiffer contact changes at the last depth of a sphere that presses on atoms.
struct ContactSensitivity {
  double force_change_relative = not_known;                 ///< at equal travel of the sphere
  double depth_change_A = not_known;                        ///< of the depth of record, at equal travel
  double force_change_at_equal_depth_relative = not_known;  ///< what a comparison of curves sees
  double deepest_penetration_A = not_known;                 ///< of an atom into the sphere
};

/// One force–depth curve. All arrays are equally long; those of the other model stay empty.
struct Run {
  Model model = Model::membrane;
  std::string load;
  Constants constants = Constants::none;
  double a_A = not_known, tip_A = not_known;        ///< radii as used (pairing radii where paired)
  double Eh_eV_per_A2 = not_known, nu = not_known;  ///< as used; for atoms those of the card
  double pretension_eV_per_A2 = 0;
  double record_radius_A = 0;  ///< where the depth of record is taken; 0: the centre
  std::optional<Ended> ended;  ///< nothing where the program that computed the curve failed
  std::string ended_reason;    ///< in words, for the table and the log

  std::vector<double> depth_A, conjugate_depth_A, force_eV_per_A, energy_eV;
  std::vector<bool> converged;

  std::vector<double> longest_bond_A;  ///< atomistic: measured; calibrated: predicted from the strain

  // atomistic
  std::vector<double> max_force_eV_per_A, balance_relative, force_error_relative;
  std::vector<bool> artefact;
  std::vector<int> force_evaluations, factorisations;

  std::optional<ContactSensitivity> contact;  ///< for a sphere

  // membrane and sheet
  std::vector<int> newton_iterations;
  int triangles = 0;                                          ///< 0: solved in one dimension
  std::shared_ptr<const std::vector<SheetPicture>> pictures;  ///< the solved triangles at the last depth, or every one

  std::optional<Fit> fit;
  std::string fit_skipped;  ///< why there is no fit
  WindowScan scan;          ///< empty where there is no fit
};

/// Indices of the points that fits, curves and the verdict use: converged, outside the artefact zone, with a
/// finite force at a finite, positive depth (every curve passes through the origin, so depth 0 says nothing).
std::vector<std::size_t> usable_points(const Run& run);

/// Index of the first point in the artefact zone, if any.
std::optional<std::size_t> first_artefact(const Run& run);

/// The potential's linear response (T = 0, flat, relaxed inside the cell).
struct CardSummary {
  double a0_A = not_known, energy_per_atom_eV = not_known;
  double C11_eV_per_A2 = not_known, C12_eV_per_A2 = not_known, C66_eV_per_A2 = not_known;
  double Eh_eV_per_A2 = not_known, nu = not_known;
  double bending_modulus_eV = not_known;
  double isotropy_error = not_known;   ///< C66 / ((C11 − C12)/2) − 1
  double artefact_bond_A = not_known;  ///< from this longest bond on, the potential's cut-off makes forces an artefact
};

/// The law made from the potential's homogeneous response, as used.
struct LawSummary {
  int degree = 0;
  double rms_misfit = not_known, worst_misfit = not_known;  ///< of the stress
  double anisotropy = not_known;      ///< left out: largest difference of the stress along zigzag or armchair
  double longest_bond_A = not_known;  ///< the law holds up to here
  bool convex = false;                ///< up to there
  double bending_modulus_eV = not_known;
  std::vector<int> power_of_I, power_of_q;  ///< terms c I^a q^b of the energy
  std::vector<double> coefficient_eV_per_A2;
};

struct Agreement {
  std::string load, against;
  std::array<double, 2> window{};  ///< depth / effective radius
  double max_relative_difference = 0, tolerance = 0;
  bool passed = false;
  std::vector<double> depth_A, ratio;  ///< the points judged, F_atoms / F_continuum
};

/// What makes up the difference between the atoms' force and that of a plain membrane (St Venant–Kirchhoff, nominal
/// radii) at the same depth: shares of that membrane's force that add up to the whole.
struct Explanation {
  std::string load;
  std::vector<double> depth_A, depth_relative;
  std::vector<double> plain_force_eV_per_A;  ///< of the membrane that is explained away
  std::vector<double> geometry;              ///< radii of clamp and tip as the atoms have them
  std::vector<double> bending;
  std::vector<double> large_strain;  ///< the potential's own response for St Venant–Kirchhoff's
  std::vector<double> anisotropy;    ///< its sixfold part; not known for a sphere, and part of the remainder there
  std::vector<double> remainder;     ///< what no continuum here has
};

/// Where a sheet of atoms is, beside the like-for-like membrane at the same depth.
enum class Regime { bending, membrane, softening, artefact };

std::string_view to_string(Regime);

/// One load's atoms against the like-for-like membrane, at every depth that both have. Ratios are atoms / membrane:
/// force and energy at equal depth, depth at equal force.
struct Comparison {
  std::string load;
  std::vector<double> depth_A, depth_relative, force_ratio, depth_ratio, energy_ratio;
  std::vector<double> calibrated_membrane_ratio, sheet_ratio;  ///< force over that of the calibrated continua
  std::vector<Regime> regime;

  /// Depths that separate the regimes, where they are crossed: force ratio down to 1 + tolerance, down to 1 −
  /// tolerance, longest bond in the artefact zone.
  double bending_to_A = not_known, softening_from_A = not_known, artefact_from_A = not_known;
  double predicted_artefact_from_A = not_known;  ///< by the calibrated sheet's strains
};

struct SheetSummary {
  double radius_A = 0, effective_radius_A = 0;
  int atoms = 0, free_atoms = 0, loaded_disc_atoms = 0;
};

/// Sums over the curves, which run side by side: they may exceed the wall time.
struct Timing {
  double wall_s = not_known, membrane_s = not_known;
  std::optional<double> atomistic_s;
  std::optional<double> force_s;   ///< inside LAMMPS: pair, neighbour, communication
  std::optional<double> setup_s;   ///< inside LAMMPS: start, and the first force of each depth with its set-up
  std::optional<double> factor_s;  ///< factorising the preconditioner
  std::optional<double> solve_s;   ///< solving with it
  std::optional<long> force_calls;
};

/// The way back of an atomistic curve.
struct Unloading {
  std::string load;
  double hysteresis_relative = not_known;  ///< work lost on the way there and back over the work put in
  std::vector<double> depth_A, conjugate_depth_A, force_eV_per_A;
};

struct Provenance {
  std::string version, git, lammps, gsl, hdf5, suitesparse, blas;
  std::string potential_file, potential_sha256, potential_edit, command_line;
};

struct Result {
  Case resolved;
  std::optional<SheetSummary> sheet;  ///< absent where no atoms were asked for
  std::optional<CardSummary> card;
  std::optional<LawSummary> law;
  std::string law_missing;  ///< why there is none
  std::vector<Run> runs;
  std::optional<Agreement> agreement;
  std::string agreement_skipped;          ///< why there is no verdict
  std::vector<Comparison> comparisons;    ///< one per load that both models computed
  std::vector<Explanation> explanations;  ///< one per load that has the calibrated sheet
  std::vector<Unloading> unloading;
  Timing timing;
  Provenance provenance;
};

/// The potential's artefact length, Å; that of most carbon potentials where there is no card.
double artefact_bond_of(const Result& result);

}  // namespace validate
