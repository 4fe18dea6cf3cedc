#include "compare/fitting/fit_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compare/base/units.hpp"

namespace validate {
namespace {

double in_N_per_m(double eV_per_A2) { return eV_per_A2 * N_per_m_per_eV_per_A2; }

constexpr int few_points = 8;
constexpr double shallow_share = 0.05;    // depth / a below which the cubic hardly shows
constexpr double good_fit = 0.01;         // rms / largest force
constexpr double large_bias = 0.03;       // of E·h
constexpr double near_artefact_A = 0.02;  // of bond length

using Warnings = std::vector<std::string>;

void negative_pretension(const Fit& fit, Warnings& found) {
  const double N0 = fit.pretension_eV_per_A2;
  if (N0 < 0 && N0 < -2 * fit.pretension_stderr_eV_per_A2)
    found.push_back(
        fmt::format("the pretension is negative ({:.3g} N/m): no taut sheet has that; it is the model's bias "
                    "or a wrong zero of depth",
                    in_N_per_m(N0)));
  else if (fit.pretension_interval_eV_per_A2[0] < 0 && fit.pretension_interval_eV_per_A2[1] > 0)
    found.push_back(fmt::format("the pretension cannot be told from none (95 %: {:.3g} … {:.3g} N/m)",
                                in_N_per_m(fit.pretension_interval_eV_per_A2[0]),
                                in_N_per_m(fit.pretension_interval_eV_per_A2[1])));
}

/// The residuals know more than noise.
void structure(const Fit& fit, Warnings& found) {
  constexpr double ordered = 3;    // standard errors
  constexpr double too_far = 1.5;  // χ² per degree of freedom
  if (fit.runs_z > ordered)
    found.push_back(fmt::format(
        "the residuals are ordered along the depth ({:.1f} standard errors fewer changes of sign than noise "
        "has): the model or its zeros are wrong, and the intervals too narrow",
        fit.runs_z));
  if (fit.chi2_per_dof > too_far && fit.points >= few_points)
    found.push_back(fmt::format(
        "χ² per degree of freedom is {:.2f}: the noise is larger than stated, or the model wrong", fit.chi2_per_dof));
}

void biased(const Fit& fit, Warnings& found) {
  if (!fit.bias) return;
  const double bias = fit.bias->Eh_read_eV_per_A2 / fit.bias->Eh_true_eV_per_A2 - 1;
  const bool looks_good = fit.rms_relative < good_fit;
  if (std::abs(bias) > large_bias)
    found.push_back(fmt::format(
        "{}E·h is read {:.1f} % too {} (known from the membrane's own curve)",
        looks_good ? fmt::format("the fit looks good (rms {:.2f} % of the largest force), yet ", 100 * fit.rms_relative)
                   : "",
        100 * std::abs(bias), bias > 0 ? "high" : "low"));
  const double truth = fit.bias->pretension_true_eV_per_A2;
  if (!(truth > 0)) return;
  const double missed = fit.bias->pretension_read_eV_per_A2 / truth - 1;
  if (std::abs(missed) > 0.1)
    found.push_back(fmt::format("the pretension is read {:.0f} % too {} (known from the membrane's own curve)",
                                100 * std::abs(missed), missed > 0 ? "high" : "low"));
}

void bending(const Fit& fit, const FitContext& context, Warnings& found) {
  if (!std::isfinite(context.bending_eV)) return;
  const double share = 16 * context.bending_eV / (context.a_A * context.a_A);
  if (share > 0.1 * std::abs(fit.pretension_eV_per_A2))
    found.push_back(
        fmt::format("bending alone reads as a pretension of 16κ/a² = {:.3g} N/m or more, beside the {:.3g} "
                    "N/m fitted",
                    in_N_per_m(share), in_N_per_m(fit.pretension_eV_per_A2)));
}

void points(const Fit& fit, const FitContext& context, Warnings& found) {
  if (fit.points < few_points) found.push_back(fmt::format("{} points are few for two parameters", fit.points));
  const double deepest = fit.window_A[1];
  if (deepest < shallow_share * context.a_A)
    found.push_back(
        fmt::format("the deepest point is at {:.3f} of the radius: too shallow for E·h", deepest / context.a_A));
  if (fit.window_A[0] > 0.5 * deepest)
    found.push_back(fmt::format("no point below half of the largest depth: the pretension is extrapolated"));
}

void atoms(const FitContext& context, Warnings& found) {
  if (context.artefact_points > 0)
    found.push_back(fmt::format("{} point(s) in the potential's artefact zone left out", context.artefact_points));
  if (context.longest_bond_A >= context.artefact_bond_A - near_artefact_A)
    found.push_back(fmt::format("a bond of {:.3f} Å among the points fitted is near the artefact zone ({:.2f} Å)",
                                context.longest_bond_A, context.artefact_bond_A));
}

void radius(const FitContext& context, Warnings& found) {
  const double share = 2 * context.radius_error_A / context.a_A;
  if (share > 0.003)
    found.push_back(fmt::format("a clamp radius uncertain by {:.2g} Å makes E·h uncertain by {:.1f} %",
                                context.radius_error_A, 100 * share));
}

void tip(const FitContext& context, Warnings& found) {
  if (context.tip_assumed_a_point)
    found.push_back(
        fmt::format("no tip radius given, so a point is assumed: a real tip makes the sheet stiffer, which a "
                    "point model reads as a larger E·h (19 % for a disc of a/30)"));
}

FitContext context_of(const Result& result, const Run& run) {
  FitContext context{.a_A = run.a_A, .artefact_bond_A = artefact_bond_of(result)};
  if (run.model != Model::atomistic) return context;
  if (result.card) context.bending_eV = result.card->bending_modulus_eV;
  if (result.sheet) context.radius_error_A = result.sheet->clamp_radius_error_A;
  context.artefact_points = static_cast<int>(std::ranges::count(run.atoms().artefact, true));
  for (const std::size_t i : usable_points(run))
    context.longest_bond_A = std::fmax(context.longest_bond_A, run.longest_bond_A[i]);
  return context;
}

/// For a fit that has no bending of its own.
FitContext without_bending_known(const Fit& fit, FitContext context) {
  if (fit.model == fitted_sheet) context.bending_eV = not_known;
  return context;
}

}  // namespace

std::vector<std::string> fit_warnings(const Fit& fit, const FitContext& context) {
  Warnings found;
  biased(fit, found);
  negative_pretension(fit, found);
  structure(fit, found);
  bending(fit, context, found);
  points(fit, context, found);
  atoms(context, found);
  radius(context, found);
  tip(context, found);
  return found;
}

void add_warnings(Result& result) {
  for (Run& run : result.runs)
    for (Fit& fit : run.fits) fit.warnings = fit_warnings(fit, without_bending_known(fit, context_of(result, run)));
}

void add_warnings(FittedCurve& curve, const ModelGeometry& geometry) {
  FitContext context{.a_A = geometry.a_A};
  context.tip_assumed_a_point = geometry.tip_A == 0;
  if (geometry.bending_eV > 0) context.bending_eV = geometry.bending_eV;
  for (Fit& fit : curve.fits) fit.warnings = fit_warnings(fit, without_bending_known(fit, context));
  const Fit* quoted = recommended_fit(curve.fits);
  constexpr double decisive = 10;
  for (const Fit& fit : curve.fits) {
    if (!quoted || &fit == quoted || fit.points != quoted->points) continue;
    const double more = quoted->minus_two_log_likelihood - fit.minus_two_log_likelihood;
    if (more > decisive)
      curve.notes.push_back(fmt::format("{} describes the points better than {} (−2 ln L smaller by {:.0f})", fit.model,
                                        quoted->model, more));
    else if (more > -decisive)
      curve.notes.push_back(
          fmt::format("the points do not tell {} from {} (−2 ln L {:+.1f})", fit.model, quoted->model, -more));
  }
}

}  // namespace validate
