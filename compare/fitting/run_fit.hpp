// A computed curve read with one model after another: what each says of E·h and pretension, all at the same depths.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "compare/fitting/force_model.hpp"
#include "compare/fitting/sheet_table.hpp"
#include "compare/results/result.hpp"

namespace validate {

/// An input of a computed curve that is uncertain, and what the model says with that input larger by its standard
/// error.
struct ComputedInputs {
  double radius_error_A = 0;           ///< of the clamp
  double force_error_relative = 1e-3;  ///< of the curve and of the model: triangles 0.05 %, meridian 0.08 %, minimiser
};

/// Least squares of E·h and σ0·h with equal weights (GSL). The points have no noise: the errors are those of the inputs
/// and numerical ones, the misfit is no part of them. Returns why there is no fit instead.
std::variant<Fit, std::string> fit_computed(const ForceModel& model, double a_A, const std::vector<double>& depth_A,
                                            const std::vector<double>& force_eV_per_A,
                                            const ComputedInputs& inputs = {});

/// The fit to the first 4, 5, … points in order of depth.
WindowScan scan_window(const ForceModel& model, const std::vector<double>& depth_A,
                       const std::vector<double>& force_eV_per_A);

/// What the ladder has beside Eq. 16 and St Venant–Kirchhoff's membrane.
struct LadderPhysics {
  std::optional<SheetPhysics> third_order, sheet;
};

/// Fits every run's usable points: Eq. 16, the membrane itself with the real tip, the third-order law and the
/// potential's own sheet (for atoms and calibrated continua), as far as all of them go. Sets `fits`, or `fit_skipped`
/// with the reason where there is nothing to trust, and for a pressure. The recommended one is the last.
void fit_runs(Result& result, const LadderPhysics& physics);

/// The same for one curve.
void fit_run(Run& run, const LadderPhysics& physics = {}, const ComputedInputs& inputs = {});

/// E·h and pretension by Eq. 16 on a run's radius and Poisson's ratio; nothing from fewer points than a fit needs.
std::optional<Eq16Reading> read_by_eq16(const Run& run, const std::vector<double>& depth_A,
                                        const std::vector<double>& force_eV_per_A);

/// Adds to the fits of the atoms what each model reads from the plain membrane of the card's constants at the same
/// depths, and to every fit its warnings.
void add_biases(Result& result);

}  // namespace validate
