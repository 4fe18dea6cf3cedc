// What a fit asks of a sheet: its force at a depth, and how that changes with E·h and pretension.
#pragma once

#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "compare/fitting/models/curve_model.hpp"

namespace validate {

/// Force (eV/Å) and its derivatives over the sheet modulus and the pretension (Å both).
struct ForceAt {
  double force = 0, by_Eh = 0, by_pretension = 0;
};

/// The same with derivatives over the depth (Å).
struct ForceAlong {
  ForceAt value, first;
  double second = 0;  ///< of the force
};

using ForceFunction = std::function<ForceAt(double depth_A, double Eh, double pretension)>;
using ForceCurve = std::function<ForceAlong(double depth_A)>;

/// A sheet under its tip.
struct ForceModel {
  /// At a depth > 0 (Å), for E·h and σ0·h in eV/Å²; the pretension may be negative.
  ForceFunction at;
  double deepest_A = std::numeric_limits<double>::infinity();  ///< beyond it nothing is known
  double relative_error = 0;                                   ///< of the forces, numerical
  double typical_Eh = 1;                                       ///< about which it is known best, eV/Å²
  /// What `at` says of one sheet at many depths, where that is cheaper than asking it; see curve_of.
  std::function<ForceCurve(double Eh, double pretension)> curve = nullptr;
};

/// One sheet at many depths: the model's own curve, else `at` and differences of it.
ForceCurve curve_of(const ForceModel& model, double Eh, double pretension);

/// The model with other forces, which `curve` does not know of.
ForceModel with_forces(ForceModel model, ForceFunction at);

/// A closed form of E·h and σ0·h.
ForceModel force_model(AnyCurveModel closed_form);

/// Σ shares × models, known as well as the first.
ForceModel sum_of(std::vector<std::pair<double, ForceModel>> parts);

/// The same sheet, all forces multiplied.
ForceModel scaled(ForceModel model, double factor);

}  // namespace validate
