// A measured curve evaluated: its noise, its zeros and every model that is asked for, all free together.
#pragma once

#include <optional>
#include <vector>

#include "compare/fitting/measured_options.hpp"
#include "compare/fitting/sheet_table.hpp"
#include "compare/input/measured_curve.hpp"
#include "compare/results/measured.hpp"

namespace validate {

/// A sheet with its tip from a table, and with each of the inputs that are uncertain larger by its error.
struct SheetModel {
  ForceModel model;
  std::vector<UncertainInput> inputs;
};

/// `physics` absent: the paper's membrane. Throws std::runtime_error where the sheet is not solved.
SheetModel sheet_model(const MeasuredOptions& options, const std::optional<SheetPhysics>& physics,
                       const TableRange& range);

/// Fits the closed form, the membrane itself with its tip and, if asked for, a sheet of another law. Throws Error (bad
/// input) where too few points are left, where forces are negative, and where no model can be fitted, with the reason.
FittedCurve evaluate(const MeasuredCurve& curve, const MeasuredOptions& options);

}  // namespace validate
