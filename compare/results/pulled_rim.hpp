// A disc whose rim slides in its plane under a dead tension T, pressed by a disc load of radius c: what the closed
// forms say of it, and what its curves are called.
#pragma once

#include <string>

#include "compare/results/result.hpp"

namespace validate {

/// Whether a run's rim was pulled.
bool has_pulled_rim(const Run& run);

/// Whether the runs of a result are of a pulled rim.
bool has_pulled_rim(const Result& result);

/// The unit of force that wrinkles leave to a point load, 2πTδ, eV/Å.
double cone_of_a_point(double tension_eV_per_A2, double depth_A);

/// F/(2πTδ) of the tension field at small slopes where all but the loaded disc is a cone, N_r r = T a: 1/(1 − 2c/3a).
double cone_factor(double tip_over_radius);

/// F/(2πTδ) of a taut sheet at depths so small that its tension stays T: 1/(ln(a/c) + ½).
double taut_factor(double tip_over_radius);

/// "tension field", "membrane that bears compression", "sheet with bending", "atoms"; with the constants of a
/// continuum.
std::string pulled_curve_in_words(const Run& run);

}  // namespace validate
