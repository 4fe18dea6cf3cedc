// A measured curve evaluated: zero of force and depth, closed form, membrane, bias, warnings.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/fitting/membrane_fit.hpp"
#include "compare/fitting/models/list.hpp"
#include "compare/fitting/run_fit.hpp"
#include "compare/input/measured_curve.hpp"
#include "compare/results/measured.hpp"

namespace validate {

/// What the user says about the experiment.
struct MeasuredOptions {
  ModelGeometry geometry;               ///< radius, ν, tip radius, κ
  bool sphere = true;                   ///< the tip; else a disc of uniform load
  std::string model = "eq16";           ///< closed form that is fitted
  std::optional<SheetPhysics> physics;  ///< of the sheet that is fitted itself; absent: the paper's membrane
  double depth_min_A = 0;               ///< points used: from this depth (after the shift) …
  std::optional<double> depth_max_A;    ///< … to this one
  std::optional<double> baseline_to_A;  ///< mean force of the points up to this raw depth is taken off
  double contact_A = 0;                 ///< raw depth of the contact point
  bool fit_contact = false;             ///< the contact point is one more parameter
  bool fit_force_zero = false;          ///< and so is the zero of force
  CurveFitOptions fit;
};

/// The fits are of the closed form and, where it works, of the sheet itself, its depths those of the curve. Throws
/// Error (bad input) where too few points are left, and where the fit does not work, with the reason.
FittedCurve evaluate(const MeasuredCurve& curve, const MeasuredOptions& options);

}  // namespace validate
