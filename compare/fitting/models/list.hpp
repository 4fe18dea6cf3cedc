// The closed-form models of a curve, each with its formula, where it holds and where it comes from.
#pragma once

#include <span>
#include <string_view>

#include "compare/fitting/models/curve_model.hpp"

namespace validate {

/// The sheet and the tip that a model describes.
struct ModelGeometry {
  double a_A = 0;         ///< clamp radius
  double nu = 0;          ///< Poisson's ratio
  double tip_A = 0;       ///< radius of the loaded disc or of the sphere; 0: a point
  double bending_eV = 0;  ///< bending modulus κ
};

/// Force over depth (eV/Å²) of a clamped plate under a uniform load on its tip, w at the centre.
double plate_stiffness(const ModelGeometry& geometry);

enum class TipShape { none, disc, sphere };

/// A model with the parameters E·h and σ0·h (eV/Å²), of the depth δ (Å). It gives the force (eV/Å), or the
/// pressure (eV/Å³) where `pressure` is set.
struct ClosedForm {
  std::string_view name, formula, validity, source;
  TipShape tip = TipShape::none;  ///< the tip radius that it needs
  bool pressure = false;
  AnyCurveModel (*make)(const ModelGeometry&) = nullptr;
};

/// All of them, by name.
std::span<const ClosedForm> closed_forms();

/// The one of that name. Throws Error (bad input) with the nearest name; `label` starts the message.
const ClosedForm& closed_form(std::string_view name, std::string_view label);

}  // namespace validate
