// A measured curve and what was found in it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/base/describe.hpp"
#include "compare/base/words.hpp"
#include "compare/input/preparation.hpp"
#include "compare/results/fit.hpp"

namespace validate {

/// Of the tip that pressed.
enum class TipKind { point, disc, sphere };
constexpr auto words(TipKind) {
  return std::array{Word{TipKind::point, "point"}, Word{TipKind::disc, "disc"}, Word{TipKind::sphere, "sphere"}};
}

struct FittedCurve {
  std::string file, model;  ///< model: the closed form that was asked for
  double radius_A = not_known, nu = not_known;
  TipKind tip = TipKind::point;
  double tip_radius_A = not_known;
  double bending_modulus_eV = 0;  ///< as given; 0: none
  std::string depth_column, force_column;
  int points_read = 0;
  double baseline_eV_per_A = 0;                 ///< taken off
  std::optional<CurvePreparation> preparation;  ///< of an instrument's curve
  std::vector<double> depth_A, force_eV_per_A;  ///< the points used, given zeros taken off
  std::vector<Fit> fits;           ///< of the closed form, of the membrane itself, of a sheet of another law
  std::string continuum;           ///< what that last one is, in words; empty: none
  std::string skipped;             ///< which model was not fitted, and why
  std::vector<std::string> notes;  ///< what the points cannot tell apart
};

void describe(SameStruct<FittedCurve> auto& curve, auto&& visit) {
  visit(Field{"file", unit::none, "the file that was read"}, curve.file);
  visit(Field{"model", unit::none, "closed form that was fitted"}, curve.model);
  visit(Field{"radius", unit::length, "of the suspended sheet"}, curve.radius_A);
  visit(Field{"nu", unit::none, "Poisson's ratio"}, curve.nu);
  visit(Field{"tip", unit::none, "shape of the tip"}, curve.tip);
  visit(Field{"tip_radius", unit::length, "radius of the tip"}, curve.tip_radius_A);
  visit(Field{"bending_modulus", unit::energy, "as given; 0: none"}, curve.bending_modulus_eV);
  visit(Field{"depth_column", unit::none, "column of the file"}, curve.depth_column);
  visit(Field{"force_column", unit::none, "column of the file"}, curve.force_column);
  visit(Field{"points_read", unit::none, "points in the file"}, curve.points_read);
  visit(Field{"baseline", unit::force, "taken off the forces"}, curve.baseline_eV_per_A);
  visit(Field{"preparation", unit::none, "signs, zeros and baseline of an instrument's curve"}.where_known(),
        curve.preparation);
  visit(Column{"depth", unit::length, "points used, given zeros taken off"}, curve.depth_A);
  visit(Column{"force", unit::force, "points used, given zeros taken off"}, curve.force_eV_per_A);
  visit(Field{"fits", unit::none, "models fitted to this curve"}, curve.fits);
  visit(Field{"continuum", unit::none, "the sheet of another law, in words"}.where_known(), curve.continuum);
  visit(Field{"skipped", unit::none, "which model was not fitted, and why"}.where_known(), curve.skipped);
  visit(Field{"notes", unit::none, "what the points cannot tell apart"}, curve.notes);
}

/// A curve, or a whole file, of which nothing could be read or fitted.
struct UnfittedCurve {
  std::string file, reason;
};

void describe(SameStruct<UnfittedCurve> auto& curve, auto&& visit) {
  visit(Field{"file", unit::none, "the file, and the curve in it"}, curve.file);
  visit(Field{"reason", unit::none, "why nothing was fitted"}, curve.reason);
}

}  // namespace validate
