// What a careful person would say about a fit before anyone uses its numbers.
#pragma once

#include <string>
#include <vector>

#include "compare/fitting/models/list.hpp"
#include "compare/results/result.hpp"

namespace validate {

/// What is known of the curve beside the fit. NaN: not known.
struct FitContext {
  double a_A = not_known;
  double bending_eV = not_known;       ///< κ of the sheet; NaN where it has none or it is not known
  double radius_error_A = not_known;   ///< by which the clamp radius may be off
  double longest_bond_A = not_known;   ///< of the points fitted
  double artefact_bond_A = not_known;  ///< of the potential
  int artefact_points = 0;             ///< left out
  bool tip_assumed_a_point = false;    ///< nothing is known of the size of the tip
};

/// Sentences, most serious first; none for a fit without reproach.
std::vector<std::string> fit_warnings(const Fit& fit, const FitContext& context);

/// Sets the warnings of every fit of a result; call when the biases are there.
void add_warnings(Result& result);

/// The same for a measured curve, and notes on which models its points tell apart.
void add_warnings(FittedCurve& curve, const ModelGeometry& geometry);

}  // namespace validate
