// A closed form fitted to a force–depth curve, with all that says how far to trust it.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "compare/fitting/models/curve_model.hpp"
#include "compare/results/result.hpp"

namespace validate {

/// How the squared residuals are weighted: all alike, by 1/force², or by 1/σ² of each point.
enum class Weighting { uniform, relative, sigma };

struct CurveFitOptions {
  Weighting weighting = Weighting::uniform;
  std::vector<double> sigma_eV_per_A;  ///< with Weighting::sigma, one per point
  bool depth_offset = false, force_offset = false;
  int bootstrap_samples = 500;
  std::uint32_t seed = 1;
};

/// Fits a model of (E·h, σ0·h) to points with positive depths and finite forces. Returns the fit, or why
/// there is none.
std::variant<Fit, std::string> fit_curve(const AnyCurveModel& model, const std::vector<double>& depth_A,
                                         const std::vector<double>& force_eV_per_A,
                                         const CurveFitOptions& options = {});

/// The fit to the first 4, 5, … points in order of depth.
WindowScan scan_window(const AnyCurveModel& model, const std::vector<double>& depth_A,
                       const std::vector<double>& force_eV_per_A, const CurveFitOptions& options = {});

/// What Eq. 16 reads from a membrane of known constants at the depths of a fit, and the correction of that
/// fit.
FitBias fit_bias(const Fit& fit, const Fit& membranes, double Eh_true, double pretension_true);

/// Fits Eq. 16 (radius and Poisson's ratio as the run used them) to the run's usable points and sets `fits`
/// and `scan`, or `fit_skipped` with the reason where there is nothing to trust, and for a pressure.
void fit_run(Run& run);

/// Adds to each closed form's fit its known bias: the like-for-like membrane's curve of the same load (for a membrane
/// its own), at the depths of the fit, fitted in the same way.
void add_biases(Result& result);

/// Adds to the fits of each run that of the membrane model itself, fitted to the same curve with the real tip. For a
/// membrane that is a check: it must give back the constants.
void add_direct_fits(Result& result);

}  // namespace validate
